#include "frame/bench.hpp"

#include "base/clock.hpp"
#include "base/error.hpp"
#include "draw/exact/rays/ray_count.hpp"
#include "draw/screen/readback.hpp"
#include "draw/screen/renderer.hpp"
#include "frame/draw_world.hpp"
#include "gl/timestamp.hpp"
#include "sim/world/survey.hpp"
#include "sim/world/world.hpp"

#include <chrono>
#include <deque>
#include <utility>

namespace simreel::frame {

namespace {

double milliseconds(Clock::time_point begin, Clock::time_point end) {
  return std::chrono::duration<double, std::milli>(end - begin).count();
}

/// Timestamps of one frame. The first is at the frame's start, and one follows each mark. Later frames
/// reuse the objects.
using Stamps = std::vector<gl::Timestamp>;

scene::Scene framed(scene::Scene shown) {
  static_cast<void>(sim::frameMotion(shown));
  return shown;
}

/// A frame that has been issued and has not been delivered yet.
struct Pending {
  int frame = 0;
  bool timed = false;
  double waited = 0;
  std::vector<std::size_t> order;  ///< for each mark, the index of the stage that ends there
  std::vector<double> cpu;         ///< CPU time (ms) of each stage, up to its mark
  Stamps stamps;
  /// number of marks that have a GPU timestamp
  std::size_t stamped = 0;
  /// names and times of the sub-stages of each object
  std::vector<std::vector<std::pair<const char*, double>>> parts;
};

}  // namespace

struct BenchRun::State {
  State(scene::Scene shown, const gl::Context& device, Timing how)
      : scene(framed(std::move(shown))),
        context(device),
        timing(how),
        depth(timing == Timing::wait ? 0 : draw::Readback::maxUnderWay - 1),
        world(scene, timing != Timing::whole),
        renderer(scene, scene.render.size, scene.render.samples),
        readback(scene.render.size) {
    followMotion(renderer, world);
    for (std::size_t i = 0; timing != Timing::whole && i < world.objectCount(); ++i)
      stepStage.push_back(stage("step " + world.stepName(i)));
  }

  scene::Scene scene;
  const gl::Context& context;
  Timing timing;
  std::size_t depth;  ///< max number of frames in flight in addition to the one being issued
  sim::World world;
  draw::Renderer renderer;
  draw::Readback readback;
  std::vector<std::size_t> stepStage;
  std::deque<Pending> pending;
  std::vector<Stamps> spare;
  Pending current;  ///< the frame whose commands are being issued
  Clock::time_point lastMark, lastDelivered;
  double lastProcessor = 0;  ///< value of processSeconds() at lastDelivered
  bool started = false;
  FrameTimes times;

  /// Returns the index of the stage with the given name. Adds the stage if it is new.
  std::size_t stage(const std::string& name) {
    auto& stages = times.stages;
    for (std::size_t i = 0; i < stages.size(); ++i)
      if (stages[i].name == name) return i;
    stages.push_back({name, std::vector<double>(times.wall.size()), {}, {}});
    if (timing == Timing::query) stages.back().gpu.resize(times.wall.size());
    return stages.size() - 1;
  }

  void stamp() {
    if (timing != Timing::query) return;
    const std::size_t next = current.order.size();
    if (current.stamps.size() <= next) current.stamps.resize(next + 1);
    current.stamps[next].record();
    current.stamped = next;
  }

  void mark(std::size_t stage) {
    if (timing == Timing::whole) return;
    if (timing == Timing::wait) glFinish();
    const auto now = Clock::now();
    current.order.push_back(stage);
    current.cpu.push_back(milliseconds(lastMark, now));
    stamp();
    lastMark = Clock::now();
  }

  void mark(const char* name) {
    if (timing != Timing::whole) mark(stage(name));
  }

  void issue(bool timed) {
    current = {};
    if (!spare.empty()) {
      current.stamps = std::move(spare.back());
      spare.pop_back();
    }
    lastMark = Clock::now();
    stamp();
    current.frame = started ? world.frame() + 1 : 0;
    current.timed = timed;
    const auto stepped = [&](std::size_t object) { mark(stepStage[object]); };
    world.advanceTo(current.frame, {}, started && !stepStage.empty() ? stepped : sim::World::Stepped());
    started = true;
    for (std::size_t i = 0; timing != Timing::whole && i < world.objectCount(); ++i)
      current.parts.push_back(world.object(i).stageTimes());
    world.startSummary();
    mark("state hash");
    drawWorld(renderer, world, [&](const char* name) { mark(name); });
    readback.start(renderer.target(), current.frame);
    mark("readback");
    context.check();
    pending.push_back(std::move(current));
  }

  void deliver() {
    Pending oldest = std::move(pending.front());
    pending.pop_front();
    const auto begin = Clock::now();
    readback.waitForOldest();
    const auto summary = world.takeSummary(true);
    SIMREEL_CHECK_EQ(summary->frame, oldest.frame);
    const auto there = Clock::now();
    const auto picture = readback.nextPicture(true);
    SIMREEL_CHECK_EQ(picture->first, oldest.frame);
    const auto end = Clock::now();
    // With Timing::wait, the CPU has already waited for every stage, so only the copy of the summary
    // remains to be waited for.
    const double waited = milliseconds(begin, there);
    if (timing == Timing::wait) {
      oldest.order.push_back(stage("state hash"));
      oldest.cpu.push_back(waited);
    } else {
      oldest.waited = waited;
    }
    if (timing != Timing::whole) {
      oldest.order.push_back(stage("readback"));
      oldest.cpu.push_back(milliseconds(there, end));
    }
    const double processor = processSeconds();
    if (oldest.timed)
      add(oldest, milliseconds(lastDelivered, Clock::now()), 1e3 * (processor - lastProcessor));
    restart();
    if (timing == Timing::query) spare.push_back(std::move(oldest.stamps));
  }

  /// Restarts the clock for the time of the next frame.
  void restart() {
    lastDelivered = Clock::now();
    lastProcessor = processSeconds();
  }

  void add(const Pending& frame, double wall, double processor) {
    times.frames.push_back(frame.frame);
    times.wall.push_back(wall);
    times.processor.push_back(processor);
    times.waited.push_back(frame.waited);
    for (StageSeries& stage : times.stages) {
      stage.cpu.push_back(0);
      if (timing == Timing::query) stage.gpu.push_back(0);
    }
    for (std::size_t i = 0; i < frame.order.size(); ++i) {
      StageSeries& stage = times.stages[frame.order[i]];
      stage.cpu.back() += frame.cpu[i];
      if (i < frame.stamped) stage.gpu.back() += frame.stamps[i + 1].millisecondsSince(frame.stamps[i]);
    }
    for (std::size_t i = 0; i < frame.parts.size(); ++i)
      for (const auto& [name, value] : frame.parts[i]) addPart(times.stages[stepStage[i]], name, value);
    for (StageSeries& stage : times.stages)
      for (StageSeries::Part& part : stage.parts) part.values.resize(times.wall.size());
  }

  void addPart(StageSeries& stage, const std::string& name, double value) const {
    for (StageSeries::Part& part : stage.parts)
      if (part.name == name) return part.values.push_back(value);
    // A part that first appears in a later frame gets a time of 0 for the earlier frames.
    stage.parts.push_back({name, std::vector<double>(times.wall.size() - 1)});
    stage.parts.back().values.push_back(value);
  }
};

Timing usualTiming() {
  return gl::softwareDriver() ? Timing::wait : Timing::query;
}

BenchRun::BenchRun(scene::Scene scene, const gl::Context& context, Timing timing)
    : state_(std::make_unique<State>(std::move(scene), context, timing)) {}
BenchRun::~BenchRun() = default;
BenchRun::BenchRun(BenchRun&&) noexcept = default;
BenchRun& BenchRun::operator=(BenchRun&&) noexcept = default;

void BenchRun::run(int warmUp, int frames, const std::function<bool()>& done) {
  State& s = *state_;
  if (!s.started) {
    // Frame 0 includes the pre-roll, so its time is not representative.
    s.issue(false);
    s.deliver();
  }
  glFinish();
  s.restart();
  // Extra frames after the timed ones keep the pipeline full until the last timed frame is delivered.
  const int all = warmUp + frames + static_cast<int>(s.depth);
  for (int i = 0; i < all; ++i) {
    s.issue(i >= warmUp && i < warmUp + frames);
    if (s.pending.size() <= s.depth) continue;
    s.deliver();
    if (!done()) break;
  }
  for (Pending& frame : s.pending) frame.timed = false;
  while (!s.pending.empty()) s.deliver();
}

void BenchRun::countRays() {
  const draw::RayCount count;
  drawWorld(state_->renderer, state_->world);
  state_->times.rays = count.rays();
}

const FrameTimes& BenchRun::times() const {
  return state_->times;
}

const scene::Scene& BenchRun::scene() const {
  return state_->scene;
}

}  // namespace simreel::frame
