#pragma once
#include "draw/exact/bindings.hpp"
#include "gl/context.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"

namespace simreel::draw {

// For kernels that include draw/exact/screen/light_read.glsl.

[[nodiscard]] inline gl::Defines lightDefines() {
  return gl::softwareDriver() ? gl::Defines{{"LIGHT_IMAGES", "1"}} : gl::Defines{};
}

/// Light to be read. It is not written by the same kernel.
inline void bindLight(const gl::Texture& light, GLuint unit, GLuint image) {
  if (gl::softwareDriver())
    light.bindImage(image, GL_READ_ONLY);
  else
    light.bind(unit);
}

}  // namespace simreel::draw
