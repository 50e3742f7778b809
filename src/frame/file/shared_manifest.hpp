#pragma once
#include "base/clock.hpp"
#include "frame/file/manifest.hpp"
#include "frame/file/output_lock.hpp"
#include "frame/file/output_name.hpp"
#include "frame/file/run_info.hpp"
#include "frame/file/run_log.hpp"

#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace simreel::frame {

/// The manifest, table of counts and run.json of an output on disk. Several programs that render different
/// frames of the same run may share these files. Not thread-safe.
class SharedManifest {
 public:
  /// Locks the frames. Throws UserError(inputOutput) if another program renders one of them.
  SharedManifest(const OutputName& output, const RunInfo& run, std::span<const int> frames);

  /// Reads the manifest of an earlier run with the same settings. Returns the entries for the frames of
  /// this run. Keeps entries for other frames whose files exist, so that rendering some frames again does
  /// not remove the other entries. If `existing` is resume or skip, throws UserError(usage) for a manifest
  /// of a different run, and warns if the manifest cannot be read.
  [[nodiscard]] std::map<int, ManifestFrame> inherit(Existing existing);
  /// Returns the machine that drew a frame found by inherit(). Returns an empty text if that machine is
  /// this one or if pictures do not depend on the machine.
  [[nodiscard]] std::string otherMachineOf(int frame) const;
  /// Writes the manifest, after syncing the folder so that the file names of the frames are durable. Merges
  /// entries that other programs have added meanwhile. Writes nothing if there are no frames, because an
  /// empty manifest would only block the next scene. If the output has no manifest, writes only the table
  /// of counts. `counts`: the table of counts; empty if there is none. An existing longer table is kept if
  /// it starts with `counts` and matches its stored hash. Throws UserError(inputOutput).
  void write(Manifest manifest, std::string_view counts = {});
  [[nodiscard]] bool ownsCheckpoint() const { return lock_.ownsCheckpoint(); }
  /// Releases the locks, so that other programs may render the frames.
  void release() noexcept { lock_.release(); }

 private:
  /// Identifies one version of a file on disk. Every write replaces the file by a new one.
  struct Version {
    unsigned long long number = 0;
    long long seconds = 0, nanoseconds = 0;
    bool operator==(const Version&) const = default;
  };
  [[nodiscard]] Version versionOnDisk() const;
  void merge();
  void storeCounts(std::string_view counts);
  void store(Manifest manifest);
  void storeRuns(const Manifest& manifest);
  void storeScene();

  OutputName output_;
  std::set<int> own_;  ///< frames that this program has locked, so that only it writes them
  OutputLock lock_;
  Manifest others_;  ///< content of the manifest when it was last read from disk, without the frames in
                     ///< own_
  Version known_;    ///< version of the manifest file whose frames of other programs are all in others_
  Clock::time_point began_ = Clock::now();
  RunRecord record_;  ///< record of this run for run.json
  RunLog log_;        ///< run.json as it was when this run began
  bool hasScene_ = false;
};

}  // namespace simreel::frame
