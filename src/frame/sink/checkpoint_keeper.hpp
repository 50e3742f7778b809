#pragma once
#include "base/clock.hpp"
#include "frame/file/checkpoint.hpp"
#include "frame/file/count_table.hpp"
#include "frame/file/run_info.hpp"
#include "frame/sink/frame_sink.hpp"
#include "sim/world/world.hpp"

#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace simreel::frame {

/// Settings for checkpoints. A run writes its state periodically, so that it can be resumed after a crash.
/// It also writes its state at chosen frames, so that other runs can start there.
struct Checkpoints {
  std::filesystem::path file;  ///< file of the periodic checkpoint; if empty, no periodic checkpoint is
                               ///< written or read
  double seconds = 60;         ///< interval between checkpoints (s); if 0, none are written
  bool resume = false;         ///< true to resume from the existing periodic checkpoint
  RunInfo run = {};
  /// Frames whose states are stored permanently, and the files of these states. With `resume`, valid
  /// existing files are kept.
  std::map<int, std::filesystem::path> keep = {};
  /// checkpoint from which the run starts; if empty, the run starts at the scene's start
  std::filesystem::path from = {};
  /// if `from` cannot be used: true to warn and start at the scene's start, false to fail
  bool checkpointOptional = false;
};

/// Writes the checkpoints of a run, restores the run from a checkpoint, and removes the periodic checkpoint
/// after the run.
class CheckpointKeeper {
 public:
  /// `lastFrame`: last frame of the scene. `needsBefore`: true if drawing a frame also needs the frame
  /// before it.
  CheckpointKeeper(Checkpoints how, const FrameSink& sink, int lastFrame, bool needsBefore);

  /// Restores `world` and `counts` from the periodic checkpoint if Checkpoints::resume is set and no frame
  /// before that checkpoint is missing. Otherwise restores Checkpoints::from, if it is set.
  void resume(const std::vector<int>& frames, const std::function<bool(int frame)>& isMissing,
              sim::World& world, CountTable& counts);
  /// Returns the frame of the restored checkpoint. If no checkpoint was restored, returns a number that is
  /// less than every frame number.
  [[nodiscard]] int resumedFrame() const { return resumedFrame_; }
  /// True if the summary belongs to a frame after the restored checkpoint. Throws UserError(different) if
  /// the summary belongs to the checkpoint's frame but has another state hash.
  [[nodiscard]] bool isAfterResume(const sim::World::Summary& summary) const;

  [[nodiscard]] bool isDue() const { return how_.seconds > 0 && secondsSince(saved_) >= how_.seconds; }
  /// True if this run writes checkpoints.
  [[nodiscard]] bool writes() const;
  /// True if the state of this frame must be stored permanently and does not exist yet.
  [[nodiscard]] bool keeps(int frame) const { return how_.keep.contains(frame); }
  /// Returns the last frame whose state must be stored permanently. If no state must be stored, returns a
  /// number that is less than every frame number.
  [[nodiscard]] int lastKept() const { return how_.keep.empty() ? beforeAll : how_.keep.rbegin()->first; }
  /// Writes the world's current state to the permanent file of its frame. Throws UserError(inputOutput).
  void keep(const std::string& stateHash, const std::string& counts, sim::World& world) const;
  /// Writes the periodic checkpoint. All earlier frames must already be stored. If writing fails, warns and
  /// writes no more checkpoints; the run continues.
  void save(const std::string& stateHash, const std::string& counts, sim::World& world);
  /// Removes the periodic checkpoint after a run has completed all frames up to `last`, unless the
  /// checkpoint is of a later frame. Also removes a partial file left by a killed process.
  void removeUnneeded(int last) const;

 private:
  static constexpr int beforeAll = std::numeric_limits<int>::min();

  [[nodiscard]] std::optional<Checkpoint> found(int last);
  [[nodiscard]] std::optional<Checkpoint> given(const std::vector<int>& frames) const;
  [[nodiscard]] bool mayDraw(int frame, const Checkpoint& checkpoint) const {
    return frame >= checkpoint.frame() + (needsBefore_ ? 1 : 0);
  }
  void begin(const Checkpoint& checkpoint, sim::World& world, CountTable& counts);

  Checkpoints how_;
  const FrameSink& sink_;
  int lastFrame_;
  bool needsBefore_;
  int stored_;  ///< frame of the checkpoint on disk; the scene's last frame if unknown
  int resumedFrame_ = beforeAll;
  std::string resumedHash_;
  std::filesystem::path resumedFile_;
  Clock::time_point saved_ = Clock::now();
};

}  // namespace simreel::frame
