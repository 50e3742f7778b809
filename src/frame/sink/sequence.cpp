#include "frame/sink/sequence.hpp"

#include "base/clock.hpp"
#include "base/error.hpp"
#include "base/log.hpp"
#include "draw/screen/readback.hpp"
#include "draw/screen/renderer.hpp"
#include "frame/file/checkpoint.hpp"
#include "frame/file/count_table.hpp"
#include "frame/file/run_info.hpp"
#include "frame/interrupt.hpp"
#include "frame/sink/frame_sink.hpp"
#include "sim/world/world.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <exception>
#include <limits>
#include <utility>

namespace simreel::frame {

namespace {

/// Adds the time of its own life to a stage.
class Stopwatch {
 public:
  explicit Stopwatch(double& stage) : stage_(stage), begin_(Clock::now()) {}
  ~Stopwatch() { stage_ += secondsSince(begin_); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& stage_;
  Clock::time_point begin_;
};

/// Times a stage: on a GPU by timer queries, since its commands run later; on a software driver by the
/// clock.
class StageTimers {
 public:
  explicit StageTimers(StageTimes& stages) : stages_(stages), byQuery_(!gl::softwareDriver()) {}

  template <class Work>
  void run(double StageTimes::*stage, int frame, Work work) {
    if (!byQuery_) {
      const Stopwatch watch(stages_.*stage);
      work();
      return;
    }
    pending_.push_back({{}, frame, stage});
    pending_.back().query.begin();
    work();
    pending_.back().query.end();
  }
  /// Waiting for the device counts for a software driver only: elsewhere the queries have it.
  template <class Work>
  void wait(double StageTimes::*stage, Work work) {
    if (byQuery_) return work();
    const Stopwatch watch(stages_.*stage);
    work();
  }
  /// Adds the results of everything up to a frame that the device has finished.
  void collect(int frame) {
    for (; !pending_.empty() && pending_.front().frame <= frame; pending_.pop_front())
      stages_.*pending_.front().stage += pending_.front().query.nanoseconds() * 1e-9;
  }

 private:
  struct Pending {
    gl::TimerQuery query;
    int frame;
    double StageTimes::*stage;
  };
  StageTimes& stages_;
  bool byQuery_;
  std::deque<Pending> pending_;
};

/// Keeps a few frames under way: while the device draws one, the last is read back and encoded.
class Pipeline {
 public:
  Pipeline(const scene::Scene& scene, const gl::Context& context, FrameSink& sink, Progress& progress,
           const BesideFrames& beside)
      : context_(context),
        sink_(sink),
        fields_(beside.fields),
        progress_(progress),
        checkpoints_(beside.checkpoints),
        lastFrame_(scene.frameCount() - 1),
        stored_(lastFrame_),
        size_(scene.render.size),
        world_(scene, false, [this](long done, long total) { prestepped(done, total); }),
        writesCounts_(beside.counts),
        counts_(scene.time.fps, world_.countNames()),
        counting_(!world_.countNames().empty()),
        renderer_(scene, scene.render.size, scene.render.samples),
        readback_(scene.render.size) {}

  /// Call first. Goes on from a checkpoint before which no frame is missing, where that is asked for.
  void begin(const std::vector<int>& frames) {
    if (fields_ != nullptr) fields_->begin(world_.drawables().fields);
    if (checkpoints_.file.empty() || !checkpoints_.resume) return;
    lastFrame_ = std::max(lastFrame_, frames.empty() ? 0 : frames.back());
    const auto checkpoint = Checkpoint::read(checkpoints_.file, checkpoints_.run, lastFrame_);
    stored_ = checkpoint ? checkpoint->frame() : std::numeric_limits<int>::min();
    if (!checkpoint) return;
    for (const int frame : frames) {
      if (frame >= checkpoint->frame()) break;
      if (!sink_.wants(frame) && (fields_ == nullptr || !fields_->misses(frame, sink_))) continue;
      info("frame {} is missing, the checkpoint is of frame {}: simulating from the start", frame,
           checkpoint->frame());
      return;
    }
    checkpoint->restore(world_);
    counts_.resume(checkpoint->counts());
    resumed_ = {checkpoint->frame(), checkpoint->stateHash()};
    info("going on from the checkpoint of frame {}", checkpoint->frame());
  }

  /// Simulates every frame up to this one, watching each for a lost state, and draws it if it is wanted.
  void render(int frame) {
    if (frame < resumed_.frame) {  // whole, or there would be no going on from there
      ++delivered_;
      progress_.frame(frame, {});
      return;
    }
    simulateTo(frame);
    const bool wanted = sink_.wants(frame);
    if (wanted) {
      if (readback_.full()) deliverOldest();
      timers_.run(&StageTimes::draw, frame, [&] { renderer_.draw(world_.time(), world_.drawables()); });
      readback_.start(renderer_.target(), frame);
    }
    waiting_.push_back({frame, wanted, {}});
    if (fields_ != nullptr) {
      const Stopwatch watch(stages_.readBack);
      waiting_.back().files = fields_->read(frame, world_.drawables().fields, sink_);
    }
    while (waiting_.size() > 2) deliverOldest();
    context_.check();
  }

  void drain() {
    while (!waiting_.empty()) deliverOldest();
  }

  /// Every count that is there, also of a run that ended early.
  void writeCounts() {
    if (writesCounts_ && !counts_.empty()) sink_.addCounts(counts_.text());
  }

  /// Between two frames: stores all before, then the state. Without room for it the run goes on.
  void saveCheckpoint() {
    if (checkpoints_.file.empty() || checkpoints_.seconds <= 0 || !started_ || world_.frame() < 0) return;
    if (!sink_.ownsCheckpoint()) return;
    drain();
    if (!seen_) {
      world_.show();
      seen_ = true;
      if (summariesUnderWay_ == sim::World::mostSummaries) takeSummary();
      world_.startSummary();
      ++summariesUnderWay_;
    }
    while (summariesUnderWay_ > 0) takeSummary();
    const Stopwatch watch(stages_.wait);
    sink_.settle();
    try {
      Checkpoint::write(checkpoints_.file, checkpoints_.run, latest_->stateHash, counts_.text(), world_);
      stored_ = world_.frame();
    } catch (const UserError& error) {
      warn("no more checkpoints: {}", error.what());
      checkpoints_.seconds = 0;
    }
    saved_ = Clock::now();
  }
  /// Once a run has all frames up to `last`: only a longer one needs the checkpoint still. Takes along what
  /// a kill in the middle of writing one has left.
  void leaveCheckpoint(int last) const {
    if (checkpoints_.file.empty() || stored_ > last || !sink_.ownsCheckpoint()) return;
    for (const char* ending : {"", ".part"}) {
      std::error_code none, error;
      const auto file = checkpoints_.file.string() + ending;
      if (!std::filesystem::is_regular_file(file, none)) continue;
      std::filesystem::remove(file, error);
      if (error) warn("cannot remove {}, which is needed no more: {}", file, error.message());
    }
  }

  [[nodiscard]] int delivered() const { return delivered_; }
  [[nodiscard]] const StageTimes& stages() const { return stages_; }

 private:
  struct Waiting {
    int frame;
    bool drawn;
    std::vector<FrameFile> files;  ///< stored when the frame is known to be sound
  };

  /// Of an object that steps before the first frame, while the world is made.
  void prestepped(long done, long total) {
    const auto now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - prestepTime_).count();
    if (prestepTime_ > Clock::time_point()) stages_.simulate += seconds;
    prestepTime_ = now;
    progress_.prepare(done, total);
    if (const int signal = interruptSignal()) throw Interrupted{signal};
  }

  /// Frame by frame, watching for signals: a pre-roll, or the way to a far frame, takes its time.
  void advanceTo(int next, bool seen) {
    const long preroll = -world_.firstFrame();
    while (world_.frame() < next) {
      if (const int signal = interruptSignal()) throw Interrupted{signal};
      seen_ = seen && world_.frame() + 1 == next;
      if (seen_)
        world_.advanceTo(next);
      else
        world_.passTo(world_.frame() + 1);
      if (world_.frame() <= 0) progress_.prepare(preroll + world_.frame(), preroll);
    }
  }

  void simulateTo(int frame) {
    while (world_.frame() < frame || !started_) {
      if (const int signal = interruptSignal(); signal != 0 && started_) throw Interrupted{signal};
      // The pre-roll is watched too: frame 0's summary tells of everything before it. Only counts need each
      // of its frames.
      const int next = started_              ? world_.frame() + 1
                       : resumed_.frame >= 0 ? resumed_.frame
                       : counting_           ? world_.firstFrame()
                                             : 0;
      timers_.run(&StageTimes::simulate, next, [&] { advanceTo(next, next >= frame || counting_); });
      started_ = true;
      if (summariesUnderWay_ == sim::World::mostSummaries) takeSummary();
      world_.startSummary();
      ++summariesUnderWay_;
      if (checkpoints_.seconds > 0 && secondsSince(saved_) >= checkpoints_.seconds) saveCheckpoint();
    }
  }

  void takeSummary() {
    latest_ = world_.takeSummary(true);
    --summariesUnderWay_;
    if (latest_->frame > resumed_.frame) {
      counts_.add(*latest_);
    } else if (latest_->stateHash != resumed_.stateHash) {
      fail(ExitCode::different,
           "the state of frame {} is {} after going on from checkpoint {}, and was {}; remove it to "
           "simulate "
           "from the start",
           latest_->frame, latest_->stateHash, checkpoints_.file.string(), resumed_.stateHash);
    }
    timers_.collect(latest_->frame - 1);  // a frame's summary comes after all of the frame before
    if (latest_->frame >= (waiting_.empty() ? world_.frame() : waiting_.front().frame))
      summaries_.push_back(*latest_);
  }

  /// The state hash of a frame that waits; summaries come in the order of frames.
  std::string stateHash(int frame) {
    while (true) {
      while (!summaries_.empty() && summaries_.front().frame < frame) summaries_.pop_front();
      if (!summaries_.empty() && summaries_.front().frame == frame) return summaries_.front().stateHash;
      SIMREEL_CHECK(summariesUnderWay_ > 0);
      takeSummary();
    }
  }

  void deliverOldest() {
    Waiting oldest = std::move(waiting_.front());
    const int number = oldest.frame;
    const StageTimes before = stages_;
    std::string hash;
    timers_.wait(&StageTimes::simulate, [&] { hash = stateHash(oldest.frame); });
    waiting_.pop_front();
    if (oldest.drawn) {
      store(std::move(oldest), std::move(hash));
    } else {
      const auto known = sink_.knownStateHash(oldest.frame);
      if (known && !known->empty() && *known != hash)
        fail(ExitCode::different,
             "frame {} is kept from an earlier run, but its state was {} and is {} now; render anew with "
             "--overwrite",
             oldest.frame, *known, hash);
      if (!oldest.files.empty())
        sink_.add({oldest.frame, std::move(hash), std::move(oldest.files)}, std::nullopt);
    }
    ++delivered_;
    progress_.frame(number, {stages_.simulate - before.simulate, stages_.draw - before.draw,
                             stages_.readBack - before.readBack, stages_.encode - before.encode});
  }

  void store(Waiting waiting, std::string hash) {
    const int frame = waiting.frame;
    // A software driver draws in the background: waiting for it is drawing time.
    timers_.wait(&StageTimes::draw, [&] { readback_.waitForOldest(); });
    timers_.collect(frame);
    Image image{size_.x, size_.y, {}};
    {
      const Stopwatch watch(stages_.readBack);
      auto taken = readback_.take(true);
      SIMREEL_CHECK(taken.has_value());
      SIMREEL_CHECK_EQ(taken->first, frame);
      image.bytes = std::move(taken->second);
    }
    const Stopwatch watch(stages_.wait);
    sink_.add({frame, std::move(hash), std::move(waiting.files)}, std::move(image));
  }

  const gl::Context& context_;
  FrameSink& sink_;
  FieldFiles* fields_;
  Progress& progress_;
  Checkpoints checkpoints_;
  int lastFrame_;  ///< of the scene, or beyond it of the run
  int stored_;     ///< frame of the checkpoint on disk: the scene's last one where that is not known
  glm::ivec2 size_;
  StageTimes stages_;
  Clock::time_point prestepTime_;
  sim::World world_;
  bool writesCounts_;
  CountTable counts_;
  bool counting_;
  draw::Renderer renderer_;
  draw::Readback readback_;
  std::deque<Waiting> waiting_;
  std::deque<sim::World::Summary> summaries_;
  std::optional<sim::World::Summary> latest_;
  int summariesUnderWay_ = 0;
  bool started_ = false;
  bool seen_ = true;  ///< whether the present frame was stepped, not passed
  int delivered_ = 0;
  struct {
    int frame = std::numeric_limits<int>::min();  ///< none: before every frame
    std::string stateHash;
  } resumed_;
  Clock::time_point saved_ = Clock::now();
  StageTimers timers_{stages_};
};

}  // namespace

SequenceResult renderSequence(const scene::Scene& scene, const gl::Context& context,
                              const std::vector<int>& frames, FrameSink& sink, Progress& progress,
                              const BesideFrames& beside) {
  SequenceResult result;
  std::exception_ptr failure;
  bool whole = false;
  progress.start(static_cast<int>(frames.size()));
  try {
    Pipeline pipeline(scene, context, sink, progress, beside);
    const double start = secondsSince(beside.began) - pipeline.stages().simulate;
    try {
      pipeline.begin(frames);
      try {
        for (const int frame : frames) {
          if (const int signal = interruptSignal()) throw Interrupted{signal};
          pipeline.render(frame);
        }
      } catch (const Interrupted& interrupted) {
        result.signal = interrupted.signal;
      }
      pipeline.drain();
      if (result.signal != 0)
        pipeline.saveCheckpoint();
      else
        whole = true;
    } catch (...) {
      failure = std::current_exception();
    }
    try {
      pipeline.writeCounts();
    } catch (...) {
      if (!failure) failure = std::current_exception();
    }
    result.frames = pipeline.delivered();
    result.stages = pipeline.stages();
    result.stages.start = start;
    if (whole && !failure && !frames.empty()) pipeline.leaveCheckpoint(frames.back());
  } catch (const Interrupted& interrupted) {  // before there was anything
    result.signal = interrupted.signal;
  } catch (...) {
    failure = std::current_exception();
  }
  const auto waited = Clock::now();
  progress.finish(failure ? "failed" : result.signal != 0 ? "interrupted" : "ok");
  try {
    sink.finish();
  } catch (...) {
    // The first failure is the cause; what the sink says after it is a consequence.
    if (!failure) failure = std::current_exception();
  }
  if (failure) std::rethrow_exception(failure);
  result.stages.encode += sink.encodeSeconds();
  result.stages.wait += secondsSince(waited);
  result.seconds = secondsSince(beside.began);
  return result;
}

}  // namespace simreel::frame
