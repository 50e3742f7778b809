#include "draw/surface/number_mips.hpp"

#include "base/error.hpp"
#include "draw/draw_state.hpp"

#include <algorithm>

namespace simreel::draw {

void NumberMips::make(const gl::Texture& texture, GLenum format) {
  SIMREEL_CHECK(format == GL_RGBA16F || format == GL_R16F);
  auto found = programs_.find(format);
  if (found == programs_.end())
    found = programs_
                .emplace(format, gl::Program::compute("draw/surface/mip_level.comp",
                                                      {{"FORMAT", format == GL_R16F ? "r16f" : "rgba16f"}}))
                .first;
  const gl::Program& program = found->second;
  glm::ivec2 above(texture.width(), texture.height());
  for (int level = 1; above != glm::ivec2(1, 1); ++level) {
    const glm::ivec2 size = glm::max(above / 2, glm::ivec2(1));
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    texture.bindImage(fieldImage, level - 1, GL_READ_ONLY, format);
    texture.bindImage(reliefImage, level, GL_WRITE_ONLY, format);
    program.set("aboveSize", above);
    program.dispatch(size.x, size.y);
    above = size;
  }
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

}  // namespace simreel::draw
