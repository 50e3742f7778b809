#pragma once
#include "gl/texture.hpp"

#include <glm/vec2.hpp>

namespace simreel::draw {

/// The finished picture, RGBA8; row 0 is its top row.
struct Picture {
  /// Throws UserError(device) naming the limit when the device has no such size.
  explicit Picture(glm::ivec2 size);

  gl::Texture color;
  gl::Framebuffer framebuffer;
};

/// What the driver's rasterizer draws into: linear light with coverage in alpha.
struct Targets {
  /// Throws UserError(device) naming the limit when the device has no such size or number of samples.
  Targets(glm::ivec2 size, int samples);

  /// Without depth and, unless `lightToo` is false, empty: light 0, alpha 0 (nothing drawn: sky).
  void clear(bool lightToo) const;

  gl::Texture light;
  gl::Texture depth;
  gl::Framebuffer scene;
};

}  // namespace simreel::draw
