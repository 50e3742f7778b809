#pragma once
#include "gl/texture.hpp"

#include <glm/vec2.hpp>

namespace simreel::draw {

/// The finished picture, RGBA8; row 0 is the top row.
struct Picture {
  /// Throws UserError(device), which names the limit, if the device does not support the size.
  explicit Picture(glm::ivec2 size);

  gl::Texture color;
  gl::Framebuffer framebuffer;
};

/// Render targets of the driver's rasterizer: linear light with coverage in alpha.
struct Targets {
  /// Throws UserError(device), which names the limit, if the device does not support the size or the number
  /// of samples.
  Targets(glm::ivec2 size, int samples);

  /// Clears depth and, if `lightToo`, light to 0 and alpha to 0 (empty: sky).
  void clear(bool lightToo) const;

  gl::Texture light;
  gl::Texture depth;
  gl::Framebuffer scene;
};

}  // namespace simreel::draw
