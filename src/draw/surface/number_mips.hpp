#pragma once
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

namespace simreel::draw {

struct MipKernel;

/// Mip levels of textures of half floats by a kernel in exact arithmetic
/// (glsl/draw/surface/mip_level.comp): what drivers make of glGenerateTextureMipmap differs. mip_levels.hpp
/// is the same for pictures.
class NumberMips {
 public:
  /// All levels from level 0, for texture fetches from then on. Level 0 may have been written by
  /// imageStore. The format is the texture's: GL_RGBA16F or GL_R16F (an invariant).
  void make(const gl::Texture& texture, GLenum format);

 private:
  gl::Kernel<MipKernel> fours_, ones_;
};

}  // namespace simreel::draw
