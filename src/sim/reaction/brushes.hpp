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

/// A ball that goes along a way, in whichever unit both have.
[[nodiscard]] Brush brushAlong(const StrokeWay& way, double radius);

/// On a volume of `size` cells that is a torus: the brush once for each of its images that may reach it.
/// Needs a way that goes round no more than maxBrushRounds times.
[[nodiscard]] std::vector<Brush> brushImages(const Brush& brush, glm::ivec3 size);
inline constexpr double maxBrushRounds = 8;

/// Rows or layers that a brush may reach among `count` along an axis: the first, and how many.
[[nodiscard]] glm::ivec2 brushRange(const Brush& brush, int axis, int count);

/// The ways that a stroke goes, from each key to the next.
[[nodiscard]] std::vector<StrokeWay> strokeLegs(const StrokeParameters& stroke);

}  // namespace simreel::sim
