#include "frame/sink/sequence.hpp"

#include "base/clock.hpp"
#include "draw/screen/renderer.hpp"
#include "frame/file/count_table.hpp"
#include "frame/interrupt.hpp"
#include "frame/sink/checkpoint_keeper.hpp"
#include "frame/sink/frames_under_way.hpp"
#include "frame/sink/stage_timers.hpp"
#include "frame/summaries.hpp"
#include "sim/world/world.hpp"

#include <algorithm>
#include <exception>
#include <limits>
#include <optional>
#include <utility>

namespace simreel::frame {

namespace {

/// True if pictures have velocity or motion vector layers, which need the previous frame.
bool keepsVelocity(const SequenceOptions& beside) {
  return beside.layers &&
         std::any_of(beside.layers->layers.begin(), beside.layers->layers.end(), [](draw::Layer layer) {
           return layer == draw::Layer::velocity || layer == draw::Layer::vector;
         });
}

/// One run of a scene: steps the world, evaluates each frame's state summary, and draws the wanted frames.
class Run {
 public:
  Run(const scene::Scene& scene, const gl::Context& context, FrameSink& sink, RunListener& progress,
      const SequenceOptions& beside)
      : context_(context),
        sink_(sink),
        progress_(progress),
        fields_(beside.fields),
        writesCounts_(beside.counts),
        keeper_(beside.checkpoints, sink, scene.frameCount() - 1,
                scene.camera.shutter.has_value() || keepsVelocity(beside)),
        world_((sim::compileWorldAhead(scene), scene), false,
               [this](long done, long total) { prestepped(done, total); }),
        counts_(scene.time.fps, world_.countNames()),
        counting_(!world_.countNames().empty()),
        summaries_(world_, [this](const auto& summary) { keepSummary(summary); }),
        frames_(scene, sink, beside.fields, progress, timers_, [this] { summaries_.takeOldest(); }),
        watch_(beside.watch) {
    if (beside.layers) frames_.keepLayers(*beside.layers);
    frames_.follow(world_);
    draw::compileAhead(scene, scene.render.size, scene.render.samples, world_.time(), world_.drawables());
    if (watch_ != nullptr)
      frames_.onPicture([this](int frame, const Image& image) { watch_->drawn(frame, image); });
  }

  /// Begins the run. Resumes from a checkpoint if requested and if no wanted frame before it is missing.
  void begin(const std::vector<int>& frames) {
    if (watch_ != nullptr) watch_->begin(world_);
    if (fields_ != nullptr) fields_->begin(world_.drawables().fields);
    keeper_.resume(
        frames, [&](int frame) { return frames_.misses(frame); }, world_, counts_);
  }

  /// Simulates all frames up to `frame`, checks each for a lost state, and draws `frame` if it is wanted.
  void render(int frame) {
    // Earlier frames are complete, because otherwise the run would not have resumed after them.
    if (frame < keeper_.resumedFrame()) return frames_.pass(frame);
    simulateTo(frame);
    const bool known = latest_ && latest_->frame == frame;
    frames_.draw(world_, known ? std::optional(latest_->stateHash) : std::nullopt);
    context_.check();
  }

  /// Simulates up to the last frame whose state must be kept.
  void simulateRest() {
    if (keeper_.lastKept() >= 0) simulateTo(keeper_.lastKept());
  }

  void drain() { frames_.drain(); }

  /// Passes all counts so far to the sink, even if the run ended early.
  void writeCounts() {
    if (writesCounts_ && !counts_.empty()) sink_.addCounts(counts_.text());
  }

  /// Stores all earlier frames, then the state. Must be called between two frames.
  void saveCheckpoint() {
    if (!started_ || world_.frame() < 0 || !keeper_.writes() || !world_.isWhole()) return;
    lookAtPresent();
    const Stopwatch time = timers_.watch(&StageTimes::wait);
    sink_.settle();
    keeper_.save(latest_->stateHash, counts_.text(), world_);
  }
  void removeCheckpoint(const std::vector<int>& frames) const {
    keeper_.removeUnneeded(frames.empty() ? std::numeric_limits<int>::max()
                                          : std::max(frames.back(), keeper_.lastKept()));
  }

  [[nodiscard]] int delivered() const { return frames_.delivered(); }
  [[nodiscard]] const StageTimes& stages() { return timers_.stages(); }

 private:
  /// While the world is being created, reports the progress of objects that step before the first frame.
  void prestepped(long done, long total) {
    const auto now = Clock::now();
    if (prestepTime_ > Clock::time_point()) timers_.stages().simulate += secondsSince(prestepTime_);
    prestepTime_ = now;
    progress_.prepare(done, total);
    throwIfInterrupted();
  }

  /// Advances frame by frame and checks for signals, because a pre-roll or a distant frame takes long.
  /// Intermediate frames use World::advanceUndrawn(), after which the state must not be drawn or read.
  /// Frame `next` also uses World::advanceUndrawn(), unless `seen` is true.
  void advanceTo(int next, bool seen) {
    const long preroll = -world_.firstFrame();
    while (world_.frame() < next) {
      throwIfInterrupted();
      seen_ = seen && world_.frame() + 1 == next;
      if (seen_)
        world_.advanceTo(next);
      else
        world_.advanceUndrawn(world_.frame() + 1);
      if (world_.frame() <= 0) progress_.prepare(preroll + world_.frame(), preroll);
    }
  }

  /// Waits until the latest summary describes the current frame.
  void lookAtPresent() {
    frames_.drain();
    if (!seen_) {
      world_.complete();
      seen_ = true;
      summaries_.start();
    }
    summaries_.takeAll();
  }

  void keepState() {
    lookAtPresent();
    const Stopwatch time = timers_.watch(&StageTimes::wait);
    keeper_.keep(latest_->stateHash, counts_.text(), world_);
  }

  /// Returns the next frame whose state summary is needed. Frame 0's summary also covers the whole
  /// pre-roll, so pre-roll frames need separate summaries only if objects have counts.
  [[nodiscard]] int nextFrame() const {
    if (started_) return world_.frame() + 1;
    if (keeper_.resumedFrame() >= 0) return keeper_.resumedFrame();
    return counting_ ? world_.firstFrame() : 0;
  }

  void simulateTo(int frame) {
    while (world_.frame() < frame || !started_) {
      if (started_) throwIfInterrupted();
      const int next = nextFrame();
      const bool watched = watch_ != nullptr && watch_->wants(next);
      const bool seen = next >= frame || counting_ || watched || keeper_.keeps(next);
      timers_.run(&StageTimes::simulate, next, [&] { advanceTo(next, seen); });
      started_ = true;
      summaries_.start();
      if (watched) watch_->made(world_);
      if (keeper_.keeps(next)) keepState();
      if (keeper_.isDue()) saveCheckpoint();
    }
  }

  void keepSummary(const sim::World::Summary& summary) {
    if (keeper_.isAfterResume(summary)) {
      counts_.add(summary);
      if (!counts_.empty() && summary.frame >= 0)
        progress_.counts(summary.frame, counts_.header(), counts_.lastRow());
    }
    // A frame's summary arrives after all device work of the previous frame.
    timers_.collect(summary.frame - 1);
    frames_.know(summary.frame, summary.stateHash);
    latest_ = summary;
  }

  const gl::Context& context_;
  FrameSink& sink_;
  RunListener& progress_;
  FieldFiles* fields_;
  bool writesCounts_;
  StageTimers timers_;
  Clock::time_point prestepTime_;
  CheckpointKeeper keeper_;
  sim::World world_;
  CountTable counts_;
  bool counting_;
  Summaries summaries_;
  FramePipeline frames_;
  FrameWatch* watch_;
  std::optional<sim::World::Summary> latest_;
  bool started_ = false;
  /// true if the current frame is ready to be drawn; false if World::advanceUndrawn() advanced to it
  bool seen_ = true;
};

}  // namespace

SequenceResult renderSequence(const scene::Scene& scene, const gl::Context& context,
                              const std::vector<int>& frames, FrameSink& sink, RunListener& progress,
                              const SequenceOptions& beside) {
  SequenceResult result;
  std::exception_ptr failure;
  bool whole = false;
  progress.start(static_cast<int>(frames.size()));
  try {
    Run run(scene, context, sink, progress, beside);
    const double start = secondsSince(beside.began) - run.stages().simulate;
    try {
      run.begin(frames);
      try {
        for (const int frame : frames) {
          throwIfInterrupted();
          run.render(frame);
        }
        run.simulateRest();
      } catch (const Interrupted& interrupted) {
        result.signal = interrupted.signal;
      }
      run.drain();
      if (result.signal != 0)
        run.saveCheckpoint();
      else
        whole = true;
    } catch (...) {
      failure = std::current_exception();
    }
    try {
      run.writeCounts();
    } catch (...) {
      if (!failure) failure = std::current_exception();
    }
    result.frames = run.delivered();
    result.stages = run.stages();
    result.stages.start = start;
    if (whole && !failure) run.removeCheckpoint(frames);
  } catch (const Interrupted& interrupted) {  // A signal arrived while the world was being created.
    result.signal = interrupted.signal;
  } catch (...) {
    failure = std::current_exception();
  }
  const auto waited = Clock::now();
  progress.clear();
  try {
    sink.finish();
  } catch (...) {
    // The first failure is the cause. Later errors of the sink are consequences.
    if (!failure) failure = std::current_exception();
  }
  result.stages.encode += sink.encodeSeconds();
  result.stages.wait += secondsSince(waited);
  progress.finish(failure ? "failed" : result.signal != 0 ? "interrupted" : "ok", result.stages);
  if (failure) std::rethrow_exception(failure);
  result.seconds = secondsSince(beside.began);
  return result;
}

}  // namespace simreel::frame
