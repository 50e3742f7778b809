#pragma once
#include "draw/camera.hpp"
#include "draw/lens.hpp"
#include "glsl/common/cpp.hpp"

#include <optional>

namespace simreel::shader {

#include "glsl/draw/exact/types.glsl"

}  // namespace simreel::shader

namespace simreel::draw {

/// Returns the uniform values with which the exact rasterizer sees the scene through a lens point. The bits
/// are the same on every machine.
[[nodiscard]] shader::ExactView exactView(const View& view, const scene::Camera& camera, glm::ivec2 size,
                                          const LensPoint& through = {});

/// True if the view is orthographic (parallel rays).
[[nodiscard]] bool isParallel(const shader::ExactView& view);
/// Returns the depth (m) of a nearness, the value that depth keys store (draw/exact/depth.glsl).
[[nodiscard]] float depthOf(const shader::ExactView& view, float near);
/// Returns the point at depth `depth` (m) on the ray through a picture position (pixels).
[[nodiscard]] glm::vec3 placeOf(const shader::ExactView& view, glm::vec2 pixel, float depth);

/// Returns the picture position (pixels) of a point (m), or of an infinitely distant point in a direction.
/// Empty if it is beside or behind the eye. pixelTowards() is also empty for orthographic views.
[[nodiscard]] std::optional<glm::dvec2> pixelOf(const shader::ExactView& view, const glm::dvec3& place);
[[nodiscard]] std::optional<glm::dvec2> pixelTowards(const shader::ExactView& view,
                                                     const glm::dvec3& direction);

/// Returns the range [x, y) of the band's rows whose rays may hit a ground plane at `height` (m). Rows
/// count from the band's first row and are rounded to multiples of `step`.
[[nodiscard]] glm::ivec2 rowsTowardsGround(const shader::ExactView& view, float height, int step);

/// Returns the nearness of a ground plane at `height` (m): x at the centre of the first pixel; y and z
/// increments per pixel to the right and down; w max by which samples of a pixel may be nearer than its
/// centre, with rounding errors.
[[nodiscard]] glm::vec4 nearOfGround(const shader::ExactView& view, float height);
/// Returns bounds of the rays of depth 1, multiplied by the near distance: x max of |x| and |z| of any ray;
/// y and z max difference of x and of z within a pixel, with rounding errors.
[[nodiscard]] glm::vec3 raysAside(const shader::ExactView& view);

}  // namespace simreel::draw
