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

/// The manifest of an output on disk, and beside it the table of counts and run.json: programs that render
/// other frames of the same run may write them, too. Use from one thread at a time.
class SharedManifest {
 public:
  /// Claims the frames. Throws UserError(inputOutput) where another program renders one of them.
  SharedManifest(const OutputName& output, const RunInfo& run, std::span<const int> frames);

  /// The frames to be rendered that an earlier manifest of the same run lists; those of others it keeps for
  /// itself, where their files exist, so that rendering some frames anew does not forget the rest. Throws
  /// UserError(usage) where `existing` is resume or skip and the manifest is of another run; one that
  /// cannot be read is a warning then.
  [[nodiscard]] std::map<int, ManifestFrame> inherit(Existing existing);
  /// The machine that drew a frame that inherit() has found, where that is another one and matters; else
  /// empty.
  [[nodiscard]] std::string otherMachineOf(int frame) const;
  /// Writes it, and before that makes the names of the frames in it last; with what others have added of
  /// their frames meanwhile. Without any frame nothing: it would only stand in the way of the next scene.
  /// `counts`, if any, is the table of counts: an existing one that begins with all of it stays where its
  /// hash holds. Throws UserError(inputOutput).
  void write(Manifest manifest, std::string_view counts = {});
  [[nodiscard]] bool ownsCheckpoint() const { return lock_.ownsCheckpoint(); }
  /// Others may have the frames.
  void release() noexcept { lock_.release(); }

 private:
  /// What tells one version of a file from the next, each of which replaces the one before.
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
  std::set<int> own_;  ///< frames that no other program writes
  OutputLock lock_;
  Manifest others_;  ///< what was last found on the disk, less our own frames
  Version known_;    ///< of the file on disk that others_ and our own frames tell all of
  Clock::time_point began_ = Clock::now();
  RunRecord record_;  ///< of this run
  RunLog log_;        ///< as it was when this run began
  bool hasScene_ = false;
};

}  // namespace simreel::frame
