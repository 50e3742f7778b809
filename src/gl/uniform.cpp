#include "gl/uniform.hpp"

#include <utility>

namespace simreel::gl {

namespace {

void put(GLuint program, GLint at, int value) {
  glProgramUniform1i(program, at, value);
}
void put(GLuint program, GLint at, unsigned value) {
  glProgramUniform1ui(program, at, value);
}
void put(GLuint program, GLint at, float value) {
  glProgramUniform1f(program, at, value);
}
void put(GLuint program, GLint at, const glm::ivec2& value) {
  glProgramUniform2i(program, at, value.x, value.y);
}
void put(GLuint program, GLint at, const glm::ivec4& value) {
  glProgramUniform4i(program, at, value.x, value.y, value.z, value.w);
}
void put(GLuint program, GLint at, const glm::vec2& value) {
  glProgramUniform2f(program, at, value.x, value.y);
}
void put(GLuint program, GLint at, const glm::vec3& value) {
  glProgramUniform3f(program, at, value.x, value.y, value.z);
}
void put(GLuint program, GLint at, const glm::vec4& value) {
  glProgramUniform4f(program, at, value.x, value.y, value.z, value.w);
}
void put(GLuint program, GLint at, const glm::mat4& value) {
  glProgramUniformMatrix4fv(program, at, 1, GL_FALSE, &value[0][0]);
}

}  // namespace

bool UniformSlot::locate(GLuint program) {
  if (!std::exchange(located, true)) location = glGetUniformLocation(program, name.c_str());
  return location >= 0;
}

void UniformSlot::putInto(GLuint program) {
  if (locate(program)) std::visit([&](const auto& one) { put(program, location, one); }, value);
}

}  // namespace simreel::gl
