#pragma once
#include "draw/camera.hpp"
#include "draw/lens.hpp"
#include "glsl/common/cpp.hpp"

#include <optional>

namespace simreel::shader {

#include "glsl/draw/exact/types.glsl"

}  // namespace simreel::shader

namespace simreel::draw {

/// Returns the uniform values of the exact rasterizer for a view through a lens point. The bits are the
/// same on every machine.
[[nodiscard]] shader::ExactView exactView(const View& view, const scene::Camera& camera, glm::ivec2 size,
                                          const LensPoint& through = {});

/// True if the view is orthographic (parallel rays).
[[nodiscard]] bool isParallel(const shader::ExactView& view);
/// Converts a nearness to a depth (m). Nearness is the value that depth keys store (draw/exact/depth.glsl).
[[nodiscard]] float depthOf(const shader::ExactView& view, float near);
/// Returns the point at depth `depth` (m) on the ray through a picture position (pixels).
[[nodiscard]] glm::vec3 placeOf(const shader::ExactView& view, glm::vec2 pixel, float depth);

/// pixelOf() returns the picture position (pixels) of a point (m), pixelOfDirection() of an infinitely
/// distant point in a direction. Both return nothing if the point is not in front of the eye.
/// pixelOfDirection() also returns nothing for orthographic views.
[[nodiscard]] std::optional<glm::dvec2> pixelOf(const shader::ExactView& view, const glm::dvec3& place);
[[nodiscard]] std::optional<glm::dvec2> pixelOfDirection(const shader::ExactView& view,
                                                         const glm::dvec3& direction);

/// Returns the range of the band's pixel rows whose rays may hit a ground plane at `height` (m): first row
/// (x, inclusive) and last row (y, exclusive). Rows count from the band's first row. Both limits are
/// rounded to multiples of `step`.
[[nodiscard]] glm::ivec2 rowsTowardsGround(const shader::ExactView& view, float height, int step);

/// Returns the nearness of a ground plane at `height` (m). x: nearness at the centre of the first pixel. y
/// and z: increase of the nearness per pixel to the right and down. w: max difference of nearness between a
/// pixel's samples and centre, including rounding errors.
[[nodiscard]] glm::vec4 groundNearnessOf(const shader::ExactView& view, float height);
/// Returns bounds of the ray directions, scaled to depth 1 and multiplied by the near distance. x: max |x|
/// and |z| of any ray. y and z: max difference of x and of z within a pixel, including rounding errors.
[[nodiscard]] glm::vec3 rayBounds(const shader::ExactView& view);

}  // namespace simreel::draw
