#pragma once
#include "sim/grid/strokes.hpp"

#include <cstddef>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Where a circle is at `time` (s), all three numbers.
[[nodiscard]] glm::vec3 strokePlace(const StrokeParameters& stroke, double time);

/// Whether it paints no more than once.
[[nodiscard]] inline bool paintsOnce(const StrokeParameters& stroke) {
  return !(stroke.until > stroke.at);
}

/// Whether it paints into the state of `time` (s), to which the step before took `seconds`: what is due
/// after time - seconds and no later.
[[nodiscard]] bool isDue(const StrokeParameters& stroke, double time, double seconds);

/// Where a stroke begins and ends; of a circle that moves, where it goes within that step.
struct StrokeWay {
  glm::vec3 from{0}, to{0};
};
[[nodiscard]] StrokeWay strokeWay(const StrokeParameters& stroke, double time, double seconds);

/// Value, seed and share of stroke number `index` of a scene in the state of `time` (s) and number `step`.
[[nodiscard]] shader::Stroke strokePaint(const StrokeParameters& stroke, int seed, std::size_t index,
                                         double time, long step);

}  // namespace simreel::sim
