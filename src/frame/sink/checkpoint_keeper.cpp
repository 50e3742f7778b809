#include "frame/sink/checkpoint_keeper.hpp"

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/log.hpp"

#include <algorithm>
#include <system_error>
#include <utility>

namespace simreel::frame {

CheckpointKeeper::CheckpointKeeper(Checkpoints how, const FrameSink& sink, int lastFrame, bool needsBefore)
    : how_(std::move(how)),
      sink_(sink),
      lastFrame_(lastFrame),
      needsBefore_(needsBefore),
      stored_(lastFrame) {}

void CheckpointKeeper::resume(const std::vector<int>& frames, const std::function<bool(int)>& isMissing,
                              sim::World& world, CountTable& counts) {
  if (!how_.file.empty() && how_.resume) {
    const int last = std::max({lastFrame_, frames.empty() ? 0 : frames.back(), lastKept()});
    const auto checkpoint = found(last);
    // A valid stored state needs no work if its frame is not after the checkpoint. If any other state up to
    // the checkpoint must be stored, it must be simulated again, so the run cannot resume from the
    // checkpoint.
    std::erase_if(how_.keep, [&](const auto& kept) {
      return checkpoint && kept.first <= checkpoint->frame() &&
             (kept.second == checkpoint->file() || Checkpoint::read(kept.second, how_.run, last));
    });
    if (checkpoint) {
      auto missing = std::find_if(frames.begin(), frames.end(), isMissing);
      if (missing != frames.end() && !mayDraw(*missing, *checkpoint))
        info("frame {} is missing, the checkpoint is of frame {}: simulating from the start", *missing,
             checkpoint->frame());
      else if (!how_.keep.empty() && how_.keep.begin()->first < checkpoint->frame())
        info("the state of frame {} is missing, the checkpoint is of frame {}: simulating from the start",
             how_.keep.begin()->first, checkpoint->frame());
      else
        return begin(*checkpoint, world, counts);
    }
  }
  if (how_.from.empty()) return;
  if (const auto checkpoint = given(frames)) begin(*checkpoint, world, counts);
}

std::optional<Checkpoint> CheckpointKeeper::given(const std::vector<int>& frames) const {
  try {
    Checkpoint checkpoint = Checkpoint::load(how_.from);
    if (const auto difference = checkpoint.mismatch(how_.run))
      fail(ExitCode::usage, "cannot begin at checkpoint {}: {}", how_.from.string(), *difference);
    if (needsBefore_ && !frames.empty() && !mayDraw(frames.front(), checkpoint)) {
      info(
          "frame {} needs the previous frame for its motion, but the checkpoint is of frame {}: simulating "
          "from the start",
          frames.front(), checkpoint.frame());
      return std::nullopt;
    }
    return checkpoint;
  } catch (const UserError& error) {
    if (!how_.checkpointOptional) throw;
    warn("{}; simulating from the start", error.what());
    return std::nullopt;
  }
}

/// Returns the run's periodic checkpoint. If it does not exist or does not fit, returns the last valid
/// permanent checkpoint.
std::optional<Checkpoint> CheckpointKeeper::found(int last) {
  auto checkpoint = Checkpoint::read(how_.file, how_.run, last);
  stored_ = checkpoint ? checkpoint->frame() : beforeAll;
  for (auto kept = how_.keep.rbegin(); kept != how_.keep.rend() && !checkpoint; ++kept)
    checkpoint = Checkpoint::read(kept->second, how_.run, last);
  return checkpoint;
}

void CheckpointKeeper::begin(const Checkpoint& checkpoint, sim::World& world, CountTable& counts) {
  checkpoint.restore(world);
  counts.resume(checkpoint.counts());
  resumedFrame_ = checkpoint.frame();
  resumedHash_ = checkpoint.stateHash();
  resumedFile_ = checkpoint.file();
  if (resumedFile_ == how_.from)
    detail("beginning at frame {} of {}", resumedFrame_, resumedFile_.string());
  else
    info("resuming from the checkpoint of frame {}", resumedFrame_);
}

void CheckpointKeeper::keep(const std::string& stateHash, const std::string& counts,
                            sim::World& world) const {
  Checkpoint::write(how_.keep.at(world.frame()), how_.run, stateHash, counts, world);
}

bool CheckpointKeeper::isAfterResume(const sim::World::Summary& summary) const {
  if (summary.frame > resumedFrame_) return true;
  if (summary.stateHash != resumedHash_)
    fail(ExitCode::different,
         "the state of frame {} is {} after resuming from checkpoint {}, but was {}; remove the checkpoint "
         "to simulate from the start",
         summary.frame, summary.stateHash, resumedFile_.string(), resumedHash_);
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
    if (error) warn("cannot remove {}, which is no longer needed: {}", file, error.message());
  }
}

}  // namespace simreel::frame
