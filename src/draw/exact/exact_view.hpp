#pragma once
#include "draw/camera.hpp"
#include "draw/lens.hpp"
#include "glsl/common/cpp.hpp"

namespace simreel::shader {

#include "glsl/draw/exact/types.glsl"

}  // namespace simreel::shader

namespace simreel::draw {

/// How the exact rasterizer sees the scene from there, through a point of the lens: the same bits on every
/// machine.
[[nodiscard]] shader::ExactView exactView(const View& view, const scene::Camera& camera, glm::ivec2 size,
                                          const LensPoint& through = {});

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
