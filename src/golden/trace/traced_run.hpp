#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace simreel::sim {
class World;
}

namespace simreel::golden {

/// An array of the state that is traced.
struct TracedArray {
  std::string object, array;
  std::int64_t elements = 0;  ///< vec4 each
  int steps = 1;              ///< of its object, a frame
  bool operator==(const TracedArray&) const = default;
  [[nodiscard]] std::string name() const { return object + "." + array; }
};

/// What two runs have to share for their states to be comparable.
struct TracedRun {
  int firstFrame = 0;               ///< that of the state before any step; negative with pre-roll
  std::vector<TracedArray> arrays;  ///< in the order of World::arrays()
};

/// Of a world that has not been stepped.
[[nodiscard]] TracedRun describeWorld(const sim::World& world);
/// Where each object's arrays begin in it.
[[nodiscard]] std::vector<std::size_t> firstArrays(const sim::World& world);
/// What users call an element of an object: "particle (12, 30)".
[[nodiscard]] std::string elementName(const sim::World& world, const std::string& object, long element);

// Where two runs part is asked by `simreel test`, which has the trace of a baseline, and by `simreel
// bisect`, which has another program; both answer by what follows.

/// Two runs that do not simulate the same.
struct RunMismatch {
  std::string here,
      there;          ///< "starts at frame -3", "has flag.positions of 63 elements in 4 steps a frame"
  TracedArray array;  ///< that not both have; of no name where it is another matter
};
[[nodiscard]] std::optional<RunMismatch> compareRuns(const TracedRun& here, const TracedRun& there);

/// Whether a step, counted from 1, of so many a frame ends before another one of the same frame: objects
/// are stepped in turn, each through the whole frame, so the one that is earliest in its time comes first.
[[nodiscard]] bool isEarlierStep(int step, int steps, int otherStep, int otherSteps);

}  // namespace simreel::golden
