#include "golden/trace/stream.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"
#include "sim/core/state_hash.hpp"

#include <algorithm>
#include <vector>

namespace simreel::golden {

namespace {

constexpr int mostUnderWay = 6;  ///< frames ahead of the one whose hashes are waited for

/// Where each object's arrays begin in World::arrays().
std::vector<std::size_t> firstArrays(const sim::World& world) {
  std::vector<std::size_t> first;
  std::size_t count = 0;
  for (std::size_t i = 0; i < world.objectCount(); ++i) {
    first.push_back(count);
    count += world.object(i).state().size();
  }
  return first;
}

std::string arrayName(const sim::World::ArrayName& array) {
  return array.object + "." + array.array;
}

/// Throws UserError(device) when a simulation lost its state.
void checkState(sim::World& world) {
  world.startSummary();
  static_cast<void>(world.takeSummary(true));
}

}  // namespace

TraceHeader describeWorld(const sim::World& world) {
  TraceHeader header;
  header.firstFrame = world.firstFrame();
  const auto arrays = world.arrays();
  std::size_t next = 0;
  for (std::size_t i = 0; i < world.objectCount(); ++i)
    for (std::size_t k = world.object(i).state().size(); k > 0; --k, ++next)
      header.arrays.push_back({arrays[next].object, arrays[next].array, arrays[next].elements,
                               world.object(i).stepsPerFrame()});
  return header;
}

void traceFrames(sim::World& world, int first, int last, const TakeLine& take) {
  const auto arrays = world.arrays();
  int underWay = 0;
  const auto printOldest = [&] {
    const auto summary = *world.takeSummary(true);
    --underWay;
    StateLine line;
    line.frame = summary.frame;
    for (std::size_t i = 0; i < arrays.size(); ++i)
      line.arrays.emplace_back(arrayName(arrays[i]), summary.arrays[i]);
    return take(stateLine(line));
  };
  for (int frame = first; frame <= last; ++frame) {
    world.advanceTo(frame);
    if (underWay == mostUnderWay && !printOldest()) return;
    world.startSummary();
    ++underWay;
  }
  while (underWay > 0)
    if (!printOldest()) return;
}

void traceSteps(sim::World& world, int frame, const TakeLine& take) {
  world.advanceTo(frame - 1);
  checkState(world);
  const auto arrays = world.arrays();
  const auto first = firstArrays(world);
  const sim::StateHash hash;
  bool wanted = true;
  world.advanceTo(frame, [&](std::size_t object, int step) {
    const auto state = world.object(object).state();
    if (!wanted || state.empty()) return;
    std::vector<glm::uvec4> sums(state.size(), glm::uvec4(0));
    const auto buffer = gl::Buffer::of<glm::uvec4>("step hash", sums);
    gl::barrier();
    for (std::size_t k = 0; k < state.size(); ++k) hash.add(*state[k].buffer, first[object] + k, buffer, k);
    gl::barrier();
    buffer.read(0, std::as_writable_bytes(std::span(sums)));
    StateLine line{frame, world.objectName(object), step, world.object(object).stepsPerFrame(), {}};
    for (std::size_t k = 0; k < state.size(); ++k)
      line.arrays.emplace_back(arrayName(arrays[first[object] + k]), sim::StateHash::text(sums[k]));
    wanted = take(stateLine(line));
  });
  if (wanted) checkState(world);
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
      dump.arrays[first[object] + k].words = state[k].buffer->readAll<std::uint32_t>();
  };
  if (frame == world.firstFrame() && step == 0) {
    for (std::size_t i = 0; i < world.objectCount(); ++i) copy(i);
    return dump;
  }
  int steps = 0;
  for (std::size_t i = 0; i < world.objectCount(); ++i)
    if (!world.object(i).state().empty()) steps = std::max(steps, world.object(i).stepsPerFrame());
  if (frame == world.firstFrame())
    fail(ExitCode::usage, "frame {} is what the scene starts from: no step leads to it; its dump is {}:0",
         frame, frame);
  if (step < 1 || step > steps)
    fail(ExitCode::usage, "frame {} has steps 1 to {}, not {}", frame, steps, step);
  world.advanceTo(frame - 1);
  world.advanceTo(frame, [&](std::size_t object, int done) {
    if (done == std::min(step, world.object(object).stepsPerFrame())) copy(object);
  });
  checkState(world);
  return dump;
}

}  // namespace simreel::golden
