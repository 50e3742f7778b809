#include "draw/screen/screen_program.hpp"

#include "gl/context.hpp"

#include <utility>

namespace simreel::draw {

ScreenTarget::ScreenTarget(const char* label, GLenum format, glm::ivec2 size)
    : texture(gl::Texture::image(label, format, size.x, size.y)), framebuffer(label, &texture, nullptr) {
  texture.wrap(GL_CLAMP_TO_EDGE);
}

ScreenProgram::ScreenProgram(const char* path, const char* layout, gl::Defines defines,
                             const char* vertices)
    : kernel_(gl::memoryPath() == gl::MemoryPath::storage) {
  if (kernel_) defines.emplace_back("KERNEL", layout);
  program_ = kernel_ ? gl::Program::compute(path, defines) : gl::Program::graphics(vertices, path, defines);
}

void ScreenProgram::fill(const gl::Texture& texture, const gl::Framebuffer& framebuffer) const {
  if (kernel_) {
    texture.bindImage(targetImage, GL_WRITE_ONLY);
    program_.dispatch(texture.width(), texture.height());
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
    return;
  }
  DrawState{.depthTest = false}.set();
  framebuffer.bind();
  program_.use();
  vertices_.bind();
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace simreel::draw
