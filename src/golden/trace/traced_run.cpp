#include "golden/trace/traced_run.hpp"

#include "sim/world/world.hpp"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

namespace simreel::golden {

TracedRun describeWorld(const sim::World& world) {
  TracedRun run;
  run.firstFrame = world.firstFrame();
  const auto arrays = world.arrays();
  for (std::size_t i = 0; i < world.objectCount(); ++i)
    for (std::size_t k = 0; k < world.object(i).state().size(); ++k) {
      const auto& array = arrays[run.arrays.size()];
      run.arrays.push_back({array.object, array.array, array.elements, world.object(i).stepsPerFrame()});
    }
  return run;
}

std::vector<std::size_t> firstArrays(const sim::World& world) {
  std::vector<std::size_t> first;
  std::size_t count = 0;
  for (std::size_t i = 0; i < world.objectCount(); ++i) {
    first.push_back(count);
    count += world.object(i).state().size();
  }
  return first;
}

std::string elementName(const sim::World& world, const std::string& object, long element) {
  for (std::size_t i = 0; i < world.objectCount(); ++i)
    if (world.objectName(i) == object) return world.object(i).elementName(element);
  return fmt::format("element {}", element);
}

std::optional<RunMismatch> compareRuns(const TracedRun& here, const TracedRun& there) {
  const auto start = [](const TracedRun& run) { return fmt::format("starts at frame {}", run.firstFrame); };
  const auto array = [](const TracedRun& run, std::size_t i) {
    if (i >= run.arrays.size()) return std::string("has no such array");
    const TracedArray& a = run.arrays[i];
    return fmt::format("has {} of {} elements in {} steps a frame", a.name(), a.elements, a.steps);
  };
  for (std::size_t i = 0; i < std::max(here.arrays.size(), there.arrays.size()); ++i) {
    if (i < here.arrays.size() && i < there.arrays.size() && here.arrays[i] == there.arrays[i]) continue;
    return RunMismatch{array(here, i), array(there, i), (i < here.arrays.size() ? here : there).arrays[i]};
  }
  if (here.firstFrame != there.firstFrame) return RunMismatch{start(here), start(there), {}};
  return std::nullopt;
}

bool isEarlierStep(int step, int steps, int otherStep, int otherSteps) {
  return std::int64_t{step} * otherSteps < std::int64_t{otherStep} * steps;
}

}  // namespace simreel::golden
