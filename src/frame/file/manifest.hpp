#pragma once
#include "base/strict_json.hpp"
#include "frame/file/run_info.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace simreel::frame {

struct ManifestFrame {
  std::string file;                               ///< name beside the manifest
  std::string bytes;                              ///< hash of that file; empty for a video
  std::string pixels;                             ///< pixelHash; empty when unknown
  std::string state;                              ///< state hash; empty when unknown
  std::map<std::string, std::string> files = {};  ///< hashes of the files beside it (fields), by name
  bool drawn = false;                             ///< by this very run; for run.json
};

/// File beside the frames: the run, and the hashes of each frame. Holds no time, no path and
/// nothing of the machine, so all runs of one scene write the same bytes; of pictures that depend on the
/// driver the fingerprint of its numerics. As text it ends with the hash of all before, by which one that
/// was changed afterwards is known.
struct Manifest {
  RunInfo run;
  std::string counts = {};  ///< hash of the table of counts; empty: there is none
  std::map<int, ManifestFrame> frames = {};
};

[[nodiscard]] std::string manifestText(const Manifest& manifest);
/// Members that it does not know are passed over: a later program may have written them. Throws JsonError.
[[nodiscard]] Manifest manifestOf(const JsonValue& object);
/// The same of a text, which has to be as it was written. Throws UserError(usage) naming the file and what
/// is wrong in it.
[[nodiscard]] Manifest parseManifest(const std::string& text, const std::string& name);
/// Nothing when the file does not exist. Throws as parseManifest does.
[[nodiscard]] std::optional<Manifest> readManifest(const std::filesystem::path& path);
/// "seed is 1 in this run and 2 in the earlier one": the first item in which frames of the two runs could
/// differ by more than a few bits of their pixels.
[[nodiscard]] std::optional<std::string> runDifference(const RunInfo& wanted, const RunInfo& stored);
/// The same for any two runs in which runDifference() finds nothing, and for no others.
[[nodiscard]] std::string runIdentity(const RunInfo& run);

}  // namespace simreel::frame
