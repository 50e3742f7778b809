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

/// Where a run's state is kept from time to time, so that it can go on after an end that nobody wanted, and
/// at chosen frames, so that other runs can begin there.
struct Checkpoints {
  std::filesystem::path file;  ///< empty: none are written or read
  double seconds = 60;         ///< between two; 0: none are written
  bool resume = false;         ///< go on from the one that is there
  RunInfo run = {};
  /// Frames whose states are kept for good, and where. With `resume` those that are there, and whole, stay.
  std::map<int, std::filesystem::path> keep = {};
  std::filesystem::path from = {};  ///< where the run begins; empty: at the scene's start
  bool mayDoWithout = false;        ///< where `from` cannot be used: from the start then, with a warning
};

/// Writes the checkpoint of one run, goes on from one, and removes it.
class CheckpointKeeper {
 public:
  /// `lastFrame` of the scene. `needsBefore`: a picture needs the frame before its own, too.
  CheckpointKeeper(Checkpoints how, const FrameSink& sink, int lastFrame, bool needsBefore);

  /// Goes on from a checkpoint before which nothing that is wanted is missing, where that is asked for;
  /// else begins at the one that was given, if any.
  void resume(const std::vector<int>& frames, const std::function<bool(int frame)>& isMissing,
              sim::World& world, CountTable& counts);
  /// The frame of that checkpoint; before every frame where there is none.
  [[nodiscard]] int resumedFrame() const { return resumedFrame_; }
  /// Whether a summary is of a frame after it. Throws UserError(different) when the frame of the checkpoint
  /// has another state now.
  [[nodiscard]] bool isAfterResume(const sim::World::Summary& summary) const;

  [[nodiscard]] bool isDue() const { return how_.seconds > 0 && secondsSince(saved_) >= how_.seconds; }
  /// Whether checkpoints are this run's to write.
  [[nodiscard]] bool writes() const;
  /// Whether the state of this frame is to be kept for good and is not there yet.
  [[nodiscard]] bool keeps(int frame) const { return how_.keep.contains(frame); }
  /// The last frame whose state is to be kept; before every frame where there is none.
  [[nodiscard]] int lastKept() const { return how_.keep.empty() ? beforeAll : how_.keep.rbegin()->first; }
  /// Keeps it. Throws UserError(inputOutput).
  void keep(const std::string& stateHash, const std::string& counts, sim::World& world) const;
  /// The state between two frames, all before which is stored. Without room for it the run goes on.
  void save(const std::string& stateHash, const std::string& counts, sim::World& world);
  /// Once a run has all frames up to `last`: only a longer one needs the checkpoint still. Takes along what
  /// a kill in the middle of writing one has left.
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
  int stored_;  ///< frame of the checkpoint on disk: the scene's last one where that is not known
  int resumedFrame_ = beforeAll;
  std::string resumedHash_;
  std::filesystem::path resumedFile_;
  Clock::time_point saved_ = Clock::now();
};

}  // namespace simreel::frame
