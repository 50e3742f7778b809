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

/// Hashes of every state array after every step of a run: enough to say where another run leaves it. Small:
/// a baseline keeps it (steps.bin).
struct StepTrace {
  struct Array {
    std::string object, name;
    std::uint32_t elements = 0;  ///< vec4 each
    std::uint32_t perBlock = 1;  ///< elements whose hashes are added up
    std::uint32_t steps = 1;     ///< a frame
    [[nodiscard]] std::uint32_t blocks() const { return (elements + perBlock - 1) / perBlock; }
    /// Words after one step: a sum for each block, then the sum of (i + 1) hash(i) over all elements.
    [[nodiscard]] std::uint32_t words() const { return blocks() + 1; }
    bool operator==(const Array&) const = default;
  };
  std::vector<Array> arrays;
  std::int32_t firstFrame = 0;  ///< its state is what the run starts from; 0, or negative with pre-roll
  std::uint32_t frames = 0;     ///< stepped to after that
  std::uint32_t detailed = 0;  ///< of them, from the start, those that have every step; the others the last
  /// The first state, then frame by frame; in each array by array, step by step.
  std::vector<std::uint32_t> words;

  /// Words of the first state (index 0) or of the frame of that index.
  [[nodiscard]] std::size_t frameWords(std::uint32_t index) const;
  [[nodiscard]] std::size_t totalWords() const;
};

/// Called after each step (counted from 1) of each object, before it is hashed, while the world stands at
/// the frame before: tests disturb the state here.
using AfterStep = std::function<void(const sim::World& world, std::size_t object, int step)>;

/// Simulates the scene from its start to `lastFrame`, without drawing, and hashes as it goes, in blocks as
/// fine as `maxBytes` allows; where not even whole arrays do, later frames keep their last step only.
/// Throws UserError as World does.
[[nodiscard]] StepTrace traceRun(const scene::Scene& scene, int lastFrame, std::size_t maxBytes,
                                 const AfterStep& afterStep = {});
/// The first step at which the run leaves the baseline; nothing when it never does in the frames that both
/// have. Traces that are cut into different blocks, or that keep every step of different frames, are
/// compared by what both know. Elements go by number.
[[nodiscard]] std::optional<Divergence> compareTraces(const StepTrace& run, const StepTrace& baseline);
/// Runs the scene as far as needed and compares; elements have the names that users know.
[[nodiscard]] std::optional<Divergence> firstDivergence(const scene::Scene& scene,
                                                        const StepTrace& baseline);

}  // namespace simreel::golden
