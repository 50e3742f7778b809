#pragma once
#include "golden/result.hpp"
#include "golden/trace/traced_run.hpp"
#include "scene/scene.hpp"
#include "sim/world/world.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace simreel::golden {

/// Hashes of all state arrays after every step of a run. They are detailed enough to find where another run
/// first differs, and small enough to be stored in a baseline (steps.bin).
struct StepTrace {
  struct Array {
    std::string object, name;
    std::uint32_t elements = 0;  ///< number of vec4 elements in the array
    std::uint32_t perBlock = 1;  ///< number of elements whose hashes are summed in a block
    std::uint32_t steps = 1;     ///< number of simulation steps per frame
    [[nodiscard]] std::uint32_t blocks() const { return (elements + perBlock - 1) / perBlock; }
    /// Returns the number of words after one step. There is one sum for each block, then the sum of (i + 1)
    /// hash(i) over all elements i.
    [[nodiscard]] std::uint32_t words() const { return blocks() + 1; }
    bool operator==(const Array&) const = default;
  };
  std::vector<Array> arrays;
  std::int32_t firstFrame = 0;  ///< frame of the initial state: 0, or negative with pre-roll
  std::uint32_t frames = 0;     ///< number of frames stepped after firstFrame
  /// number of frames, from the start, that store every step; the frames after them store only the last
  /// step
  std::uint32_t detailed = 0;
  /// Words of the initial state, then of each frame. Within a frame they are ordered by array, then by
  /// step.
  std::vector<std::uint32_t> words;

  /// Returns the number of words of the initial state (index 0) or of the frame with that index.
  [[nodiscard]] std::size_t frameWords(std::uint32_t index) const;
  [[nodiscard]] std::size_t totalWords() const;
};

/// Callback after each step (from 1) of each object, before the state is hashed. The world's current frame
/// is still the previous one. Tests use it to modify the state.
using AfterStep = std::function<void(const sim::World& world, std::size_t object, int step)>;

/// Simulates the scene from its start to `lastFrame` without drawing, and hashes every step in blocks as
/// fine as `maxBytes` allows. If even one block per array is too large, later frames keep only their last
/// step. Throws the same errors as World.
[[nodiscard]] StepTrace traceRun(const scene::Scene& scene, int lastFrame, std::size_t maxBytes,
                                 const AfterStep& afterStep = {});
/// Returns the first step at which a run differs from the baseline, or nothing if all frames that both
/// contain are equal. Traces with different blocks or different numbers of detailed frames are first
/// reduced to their common detail. Elements are named by index.
[[nodiscard]] std::optional<Divergence> compareTraces(const StepTrace& run, const StepTrace& baseline);
/// Runs the scene as far as needed and compares it with the baseline. Elements get their user-visible
/// names.
[[nodiscard]] std::optional<Divergence> firstDivergence(const scene::Scene& scene,
                                                        const StepTrace& baseline);

}  // namespace simreel::golden
