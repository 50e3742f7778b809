#pragma once
#include "gl/texture.hpp"

#include <glm/vec2.hpp>

namespace simreel::draw {

/// What the passes draw into: linear light with coverage in alpha, and the finished picture.
struct Targets {
  /// Throws UserError(device) naming the limit when the device has no such size or number of samples.
  Targets(glm::ivec2 size, int samples);

  /// Without depth and, unless `lightToo` is false, empty: light 0, alpha 0 (nothing drawn: sky).
  void clear(bool lightToo) const;
  /// Before kernels read light and depth: nothing draws into them any more.
  void finish() const;

  gl::Texture light;
  gl::Texture depth;
  gl::Framebuffer scene;
  gl::Texture color;
  gl::Framebuffer picture;
};

}  // namespace simreel::draw
