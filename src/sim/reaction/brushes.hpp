#pragma once
#include "sim/grid/stroke_ways.hpp"

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#define FUNCTION inline
#define precise
namespace simreel::shader {
#include "glsl/reaction/brush.glsl"
}  // namespace simreel::shader
#undef precise
#undef FUNCTION

namespace simreel::sim {

using shader::Brush;

/// Returns the brush of a ball that moves along a path. Path and radius are in the same unit, which is
/// arbitrary.
[[nodiscard]] Brush brushAlong(const StrokeWay& way, double radius);

/// Returns, for a periodic volume of `size` cells, one brush for each periodic image that may touch the
/// volume. The path must wrap around at most maxBrushRounds times.
[[nodiscard]] std::vector<Brush> brushImages(const Brush& brush, glm::ivec3 size);
inline constexpr double maxBrushRounds = 8;

/// Returns the first index and the number of rows or layers that a brush may touch, out of `count` along an
/// axis.
[[nodiscard]] glm::ivec2 brushRange(const Brush& brush, int axis, int count);

/// Returns the segments of a stroke's path, one for each pair of consecutive keyframes.
[[nodiscard]] std::vector<StrokeWay> strokeLegs(const StrokeParameters& stroke);

}  // namespace simreel::sim
