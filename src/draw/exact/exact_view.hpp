#pragma once
#include "draw/camera.hpp"
#include "draw/lens.hpp"
#include "glsl/common/cpp.hpp"

#include <optional>

namespace simreel::shader {

#include "glsl/draw/exact/types.glsl"

}  // namespace simreel::shader

namespace simreel::draw {

/// How the exact rasterizer sees the scene from there, through a point of the lens: the same bits on every
/// machine.
[[nodiscard]] shader::ExactView exactView(const View& view, const scene::Camera& camera, glm::ivec2 size,
                                          const LensPoint& through = {});

/// Whether its rays are parallel.
[[nodiscard]] bool isParallel(const shader::ExactView& view);
/// Depth (m) of what is so near, as keys of visibility have it.
[[nodiscard]] float depthOf(const shader::ExactView& view, float near);
/// What lies at that depth (m) on the ray through a place of the picture (pixels).
[[nodiscard]] glm::vec3 placeOf(const shader::ExactView& view, glm::vec2 pixel, float depth);

/// Where a place (m), or what lies infinitely far away in a direction, is seen: pixels. Nothing of what is
/// beside or behind the eye.
[[nodiscard]] std::optional<glm::dvec2> pixelOf(const shader::ExactView& view, const glm::dvec3& place);
[[nodiscard]] std::optional<glm::dvec2> pixelTowards(const shader::ExactView& view,
                                                     const glm::dvec3& direction);

/// From which row of the band to before which one rays may meet a ground of that height (m); rows count
/// from the band's first, in whole multiples of `step`.
[[nodiscard]] glm::ivec2 rowsTowardsGround(const shader::ExactView& view, float height, int step);

/// How near a ground of that height (m) is on the picture, as keys of visibility have it: in the middle of
/// the first pixel, what one to the right and one below add to it, and by how much samples of a pixel may
/// be nearer, rounding included.
[[nodiscard]] glm::vec4 nearOfGround(const shader::ExactView& view, float height);
/// Times the nearest depth: the most that a ray of depth 1 goes along x or z, and how much each of these
/// differs within a pixel, rounding included.
[[nodiscard]] glm::vec3 raysAside(const shader::ExactView& view);

}  // namespace simreel::draw
