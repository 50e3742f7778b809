#include "golden/trace/stream.hpp"

#include "base/error.hpp"
#include "draw/exact/pass_list.hpp"
#include "draw/screen/renderer.hpp"
#include "frame/draw_world.hpp"
#include "frame/interrupt.hpp"
#include "frame/summaries.hpp"
#include "gl/element_array.hpp"
#include "golden/trace/traced_run.hpp"
#include "sim/core/state_hash.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

namespace simreel::golden {

namespace {

/// Draws the current frame of a world and stores the outputs of all passes.
class PassDrawer {
 public:
  PassDrawer(const scene::Scene& scene, sim::World& world) : world_(world), renderer_(made(scene)) {
    renderer_.keepPasses(&passes_);
    frame::followMotion(renderer_, world_);
  }
  ~PassDrawer() { world_.onFrameBefore({}); }
  PassDrawer(const PassDrawer&) = delete;
  PassDrawer& operator=(const PassDrawer&) = delete;
  PassDrawer(PassDrawer&&) = delete;
  PassDrawer& operator=(PassDrawer&&) = delete;
  [[nodiscard]] const draw::PassPicture& draw() {
    frame::drawWorld(renderer_, world_);
    return passes_;
  }

 private:
  static draw::Renderer made(const scene::Scene& scene) {
    if (scene.render.rasterizer != scene::Rasterizer::exact)
      fail(ExitCode::usage, "passes need the exact rasterizer; use --rasterizer exact");
    return {scene, scene.render.size, scene.render.samples};
  }

  sim::World& world_;
  draw::Renderer renderer_;
  draw::PassPicture passes_;
};

}  // namespace

void drawPasses(const scene::Scene& scene, sim::World& world, std::span<const int> frames,
                const std::function<void(const PassDump& drawn)>& sink) {
  PassDrawer drawer(scene, world);
  for (const int frame : frames) {
    frame::throwIfInterrupted();
    world.advanceTo(frame);
    frame::checkState(world);
    sink({frame, drawer.draw()});
  }
}

void traceFrames(sim::World& world, int first, int last, const LineSink& sink,
                 const scene::Scene* pictures) {
  const auto arrays = describeWorld(world).arrays;
  bool wanted = true;
  std::optional<PassDrawer> drawer;
  if (pictures != nullptr) drawer.emplace(*pictures, world);
  std::map<int, PassHashes> passes;  // hashes of frames whose lines have not been written yet
  frame::Summaries summaries(world, [&](const sim::World::Summary& summary) {
    if (!wanted) return;
    StateLine line;
    line.frame = summary.frame;
    for (std::size_t i = 0; i < arrays.size(); ++i)
      line.arrays.emplace_back(arrays[i].name(), summary.arrays[i]);
    if (const auto drawn = passes.extract(summary.frame))
      for (const std::string& pass : draw::passNames())
        if (const auto hash = drawn.mapped().find(pass); hash != drawn.mapped().end())
          line.passes.emplace_back(*hash);
    wanted = sink(stateLine(line));
  });
  for (int frame = first; wanted && frame <= last; ++frame) {
    world.advanceTo(frame);
    if (drawer && frame >= 0) passes[frame] = hashesOf(drawer->draw());
    summaries.start();
  }
  if (wanted) summaries.takeAll();
}

void traceSteps(sim::World& world, int frame, const LineSink& sink) {
  world.advanceTo(frame - 1);
  frame::checkState(world);
  const auto arrays = describeWorld(world).arrays;
  const auto first = firstArrays(world);
  const sim::StateHash hash;
  bool wanted = true;
  world.advanceTo(frame, [&](std::size_t object, int step) {
    const auto state = world.object(object).state();
    if (!wanted || state.empty()) return;
    std::vector<glm::uvec4> sums(state.size(), glm::uvec4(0));
    const auto buffer = gl::Buffer::of<glm::uvec4>("step hash", sums);
    gl::barrier();
    for (std::size_t k = 0; k < state.size(); ++k) hash.add(state[k], first[object] + k, buffer, k);
    gl::barrier();
    buffer.read(0, std::as_writable_bytes(std::span(sums)));
    StateLine line{frame, world.objectName(object), step, world.object(object).stepsPerFrame(), {}};
    for (std::size_t k = 0; k < state.size(); ++k)
      line.arrays.emplace_back(arrays[first[object] + k].name(), sim::StateHash::text(sums[k]));
    wanted = sink(stateLine(line));
  });
  if (wanted) frame::checkState(world);
}

StateDump dumpState(sim::World& world, int frame, int step) {
  StateDump dump;
  dump.frame = frame;
  dump.step = step;
  const auto arrays = world.arrays();
  for (const auto& array : arrays) dump.arrays.push_back({array.object, array.array, {}});
  const auto first = firstArrays(world);
  const auto copy = [&](std::size_t object) {
    gl::barrier();
    const auto state = world.object(object).state();
    for (std::size_t k = 0; k < state.size(); ++k)
      dump.arrays[first[object] + k].words = state[k].readAll<std::uint32_t>();
  };
  if (frame == world.firstFrame() && step == 0) {
    for (std::size_t i = 0; i < world.objectCount(); ++i) copy(i);
    return dump;
  }
  int steps = 0;
  for (std::size_t i = 0; i < world.objectCount(); ++i)
    if (!world.object(i).state().empty()) steps = std::max(steps, world.object(i).stepsPerFrame());
  if (frame == world.firstFrame())
    fail(ExitCode::usage, "frame {} is the initial state, so it has no steps; dump it with {}:0", frame,
         frame);
  if (step < 1 || step > steps)
    fail(ExitCode::usage, "frame {} has steps 1 to {}, not {}", frame, steps, step);
  world.advanceTo(frame - 1);
  world.advanceTo(frame, [&](std::size_t object, int done) {
    if (done == std::min(step, world.object(object).stepsPerFrame())) copy(object);
  });
  frame::checkState(world);
  return dump;
}

}  // namespace simreel::golden
