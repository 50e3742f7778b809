#pragma once
#include "sim/grid/strokes.hpp"

#include <cstddef>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Returns the position of a circle stroke at `time` (seconds), with all three components.
[[nodiscard]] glm::vec3 strokePlace(const StrokeParameters& stroke, double time);

/// Returns true if the stroke has no duration and paints only once.
[[nodiscard]] inline bool paintsOnce(const StrokeParameters& stroke) {
  return !(stroke.until > stroke.at);
}

/// Returns true if the stroke paints into the state at `time` (seconds) that follows a step of `seconds`.
/// This is so if it is active in the interval (time - seconds, time].
[[nodiscard]] bool isDue(const StrokeParameters& stroke, double time, double seconds);

/// Start and end of a stroke, or for a moving circle the start and end of its path within the step.
struct StrokeWay {
  glm::vec3 from{0}, to{0};
};
[[nodiscard]] StrokeWay strokeWay(const StrokeParameters& stroke, double time, double seconds);

/// Returns a shader::Stroke in which only value, seed and picked are set, from stroke number `index` at
/// `time` (seconds) in step `step`. The caller sets the geometry.
[[nodiscard]] shader::Stroke strokePaint(const StrokeParameters& stroke, int seed, std::size_t index,
                                         double time, long step);

}  // namespace simreel::sim
