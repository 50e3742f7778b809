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

/// A state array that is traced.
struct TracedArray {
  std::string object, array;
  std::int64_t elements = 0;  ///< number of vec4 elements in the array
  int steps = 1;              ///< number of steps per frame of the array's object
  bool operator==(const TracedArray&) const = default;
  [[nodiscard]] std::string name() const { return object + "." + array; }
};

/// Properties that two runs must share for their states to be comparable.
struct TracedRun {
  int firstFrame = 0;               ///< frame of the state before any step; negative with pre-roll
  std::vector<TracedArray> arrays;  ///< state arrays in the order of World::arrays()
};

/// Describes a world that has not been stepped yet.
[[nodiscard]] TracedRun describeWorld(const sim::World& world);
/// Returns the index of each object's first array in World::arrays().
[[nodiscard]] std::vector<std::size_t> firstArrays(const sim::World& world);
/// Returns the user-visible name of an element of an object: "particle (12, 30)".
[[nodiscard]] std::string elementName(const sim::World& world, const std::string& object, long element);

// `simreel test` and `simreel bisect` both use the functions below. The former compares with a baseline's
// trace, the latter with another program.

/// First difference that makes two runs incomparable.
struct RunMismatch {
  /// Properties in which the two sides differ, such as "starts at frame -3" and "has flag.positions of 63
  /// elements in 4 steps a frame".
  std::string here, there;
  /// array that differs or that only one side has; without names if the difference is not in an array
  TracedArray array;
};
[[nodiscard]] std::optional<RunMismatch> compareRuns(const TracedRun& here, const TracedRun& there);

/// True if `step` (from 1) ends before `otherStep` of the same frame in simulated time. This is needed
/// because each object is stepped through a whole frame before the next object.
[[nodiscard]] bool isEarlierStep(int step, int steps, int otherStep, int otherSteps);

}  // namespace simreel::golden
