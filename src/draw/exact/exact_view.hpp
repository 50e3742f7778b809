#pragma once
#include "draw/camera.hpp"
#include "glsl/common/cpp.hpp"

namespace simreel::shader {

#include "glsl/draw/exact/types.glsl"

}  // namespace simreel::shader

namespace simreel::draw {

/// How the exact rasterizer sees the scene from there: the same bits on every machine.
[[nodiscard]] shader::ExactView exactView(const View& view, const scene::Camera& camera, glm::ivec2 size);

/// From which row of the band to before which one rays may meet a ground of that height (m); rows count
/// from the band's first, in whole multiples of `step`.
[[nodiscard]] glm::ivec2 rowsTowardsGround(const shader::ExactView& view, float height, int step);

}  // namespace simreel::draw
