#pragma once
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

namespace simreel::draw {

struct MipKernel;

/// Computes mip levels of half-float textures with a kernel in exact arithmetic
/// (glsl/draw/surface/mip_level.comp), because the results of glGenerateTextureMipmap differ between
/// drivers. mip_levels.hpp computes the mip levels of image files.
class NumberMips {
 public:
  /// Computes all levels from level 0 and makes them visible to texture fetches. Level 0 may have been
  /// written by imageStore. `format` must be the texture's format, GL_RGBA16F or GL_R16F.
  void make(const gl::Texture& texture, GLenum format);

 private:
  gl::Kernel<MipKernel> fours_, ones_;
};

}  // namespace simreel::draw
