#pragma once
#include "base/strict_json.hpp"
#include "frame/file/run_info.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace simreel::frame {

struct ManifestFrame {
  /// file name of the picture, relative to the manifest's folder
  std::string file;
  std::string bytes;   ///< hash of the picture file's bytes; empty for a video
  std::string pixels;  ///< pixel hash (pixelHash()); empty if unknown
  std::string state;   ///< state hash of the simulations; empty if unknown
  /// hashes of the frame's other files (fields) by file name
  std::map<std::string, std::string> files = {};
  bool drawn = false;  ///< true if this process drew the frame; recorded in run.json
};

/// Content of manifest.json. This file is next to the frames, describes the run and holds the hashes of
/// each frame. The manifest contains no time, path or machine, so all runs of one scene write the same
/// bytes. If the pictures depend on the driver, the manifest also contains the fingerprint of the driver's
/// numerics. The text ends with a hash of everything before it, so that later changes are detected.
struct Manifest {
  RunInfo run;
  std::string counts = {};  ///< hash of the table of counts; empty if there is no table
  std::map<int, ManifestFrame> frames = {};
};

[[nodiscard]] std::string manifestText(const Manifest& manifest);
/// Reads a manifest from JSON. Ignores unknown members, because a later program version may have written
/// them. Throws JsonError.
[[nodiscard]] Manifest manifestOf(const JsonValue& object);
/// Reads a manifest from text and checks the hash at its end. On failure, throws UserError(usage), whose
/// message contains the file's `name` and the mistake.
[[nodiscard]] Manifest parseManifest(const std::string& text, const std::string& name);
/// Reads a manifest file. Returns nothing if the file does not exist. Throws the same errors as
/// parseManifest().
[[nodiscard]] std::optional<Manifest> readManifest(const std::filesystem::path& path);
/// True if the file is JSON of another program: an object with members that is not a simreel manifest.
/// Damaged manifests, and files that cannot be read, are not foreign.
[[nodiscard]] bool isForeignManifest(const std::filesystem::path& path);
/// Returns the first setting that differs between two runs and may change pixels by more than a few bits.
/// The result is text such as "seed is 1 in this run and 2 in the earlier one". Returns nothing if no such
/// setting differs.
[[nodiscard]] std::optional<std::string> runDifference(const RunInfo& wanted, const RunInfo& stored);
/// Returns a hash that is equal for two runs exactly if runDifference() finds no difference.
[[nodiscard]] std::string runIdentity(const RunInfo& run);

}  // namespace simreel::frame
