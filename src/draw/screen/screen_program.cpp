#include "draw/screen/screen_program.hpp"

namespace simreel::draw {

ScreenTarget::ScreenTarget(const char* label, GLenum format, glm::ivec2 size)
    : texture(gl::Texture::image(label, format, size.x, size.y)), framebuffer(label, &texture, nullptr) {
  texture.wrap(GL_CLAMP_TO_EDGE);
}

}  // namespace simreel::draw
