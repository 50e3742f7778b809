#include "gl/kernel/give.hpp"

namespace simreel::gl {

void bindByName(GLuint program, const char* name, const Resource& resource) {
  if (resource.texture() != nullptr) {
    const GLint location = glGetUniformLocation(program, name);
    if (location < 0) return;
    GLint unit = 0;
    glGetUniformiv(program, location, &unit);
    glBindTextureUnit(static_cast<GLuint>(unit), resource.texture()->name());
  } else if (resource.buffer() != 0) {
    const GLuint index = glGetUniformBlockIndex(program, name);
    if (index == GL_INVALID_INDEX) return;
    GLint binding = 0;
    glGetActiveUniformBlockiv(program, index, GL_UNIFORM_BLOCK_BINDING, &binding);
    glBindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(binding), resource.buffer());
  }
}

}  // namespace simreel::gl
