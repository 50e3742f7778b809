#pragma once
#include "gl/texture.hpp"

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Framebuffer of the finished picture, RGBA8. Row 0 is the top row.
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

  /// Clears depth. If `lightToo`, also sets light and alpha to 0, which means sky.
  void clear(bool lightToo) const;

  gl::Texture light;
  gl::Texture depth;
  gl::Framebuffer scene;
};

}  // namespace simreel::draw
