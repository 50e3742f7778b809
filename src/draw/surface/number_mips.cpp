#include "draw/surface/number_mips.hpp"

#include "base/error.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <string>

namespace simreel::draw {

struct MipKernel {
  static constexpr auto file = "draw/surface/mip_level.comp";
  struct Variant {
    gl::Code<"FORMAT", "rgba16f"> format;
  };
  gl::In<"above"> above;
  gl::Out<"below"> below;
  gl::Uniform<"aboveSize", glm::ivec2> aboveSize;
};

void NumberMips::make(const gl::Texture& texture, GLenum format) {
  SIMREEL_CHECK(format == GL_RGBA16F || format == GL_R16F);
  gl::Kernel<MipKernel>& kernel = format == GL_R16F ? ones_ : fours_;
  if (!kernel)
    kernel = gl::Kernel<MipKernel>(gl::Defines(),
                                   {.format = std::string(format == GL_R16F ? "r16f" : "rgba16f")});
  glm::ivec2 above(texture.width(), texture.height());
  for (int level = 1; above != glm::ivec2(1, 1); ++level) {
    const glm::ivec2 size = glm::max(above / 2, glm::ivec2(1));
    kernel.dispatch(size, {.above = gl::Resource(texture, level - 1, format),
                           .below = gl::Resource(texture, level, format),
                           .aboveSize = above});
    above = size;
  }
  gl::barrier();
}

}  // namespace simreel::draw
