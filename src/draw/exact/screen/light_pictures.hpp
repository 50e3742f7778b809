#pragma once
#include "gl/context.hpp"
#include "gl/shader_source.hpp"

namespace simreel::draw {

/// Returns the defines of kernels that include draw/exact/screen/light_read.glsl.
[[nodiscard]] inline gl::Defines lightDefines() {
  return gl::softwareDriver() ? gl::Defines{{"LIGHT_IMAGES", "1"}} : gl::Defines{};
}

}  // namespace simreel::draw
