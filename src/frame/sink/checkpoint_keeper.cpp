#include "frame/sink/checkpoint_keeper.hpp"

#include "base/error.hpp"
#include "base/log.hpp"
#include "frame/file/checkpoint.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

namespace simreel::frame {

CheckpointKeeper::CheckpointKeeper(Checkpoints how, const FrameSink& sink, int lastFrame)
    : how_(std::move(how)), sink_(sink), lastFrame_(lastFrame), stored_(lastFrame) {}

void CheckpointKeeper::resume(const std::vector<int>& frames, const std::function<bool(int)>& isMissing,
                              sim::World& world, CountTable& counts) {
  if (how_.file.empty() || !how_.resume) return;
  const int last = std::max(lastFrame_, frames.empty() ? 0 : frames.back());
  const auto checkpoint = Checkpoint::read(how_.file, how_.run, last);
  stored_ = checkpoint ? checkpoint->frame() : beforeAll;
  if (!checkpoint) return;
  for (const int frame : frames) {
    if (frame >= checkpoint->frame()) break;
    if (!isMissing(frame)) continue;
    info("frame {} is missing, the checkpoint is of frame {}: simulating from the start", frame,
         checkpoint->frame());
    return;
  }
  checkpoint->restore(world);
  counts.resume(checkpoint->counts());
  resumedFrame_ = checkpoint->frame();
  resumedHash_ = checkpoint->stateHash();
  info("going on from the checkpoint of frame {}", resumedFrame_);
}

bool CheckpointKeeper::isAfterResume(const sim::World::Summary& summary) const {
  if (summary.frame > resumedFrame_) return true;
  if (summary.stateHash != resumedHash_)
    fail(ExitCode::different,
         "the state of frame {} is {} after going on from checkpoint {}, and was {}; remove it to simulate "
         "from the start",
         summary.frame, summary.stateHash, how_.file.string(), resumedHash_);
  return false;
}

bool CheckpointKeeper::writes() const {
  return !how_.file.empty() && how_.seconds > 0 && sink_.ownsCheckpoint();
}

void CheckpointKeeper::save(const std::string& stateHash, const std::string& counts, sim::World& world) {
  try {
    Checkpoint::write(how_.file, how_.run, stateHash, counts, world);
    stored_ = world.frame();
  } catch (const UserError& error) {
    warn("no more checkpoints: {}", error.what());
    how_.seconds = 0;
  }
  saved_ = Clock::now();
}

void CheckpointKeeper::removeUnneeded(int last) const {
  if (how_.file.empty() || stored_ > last || !sink_.ownsCheckpoint()) return;
  for (const char* ending : {"", ".part"}) {
    std::error_code none, error;
    const auto file = how_.file.string() + ending;
    if (!std::filesystem::is_regular_file(file, none)) continue;
    std::filesystem::remove(file, error);
    if (error) warn("cannot remove {}, which is needed no more: {}", file, error.message());
  }
}

}  // namespace simreel::frame
