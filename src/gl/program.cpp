#include "gl/program.hpp"

#include "base/error.hpp"
#include "gl/errors.hpp"
#include "gl/limits.hpp"

namespace simreel::gl {

namespace {

Handle<DeleteShader> compile(GLenum stage, const std::string& path, const ShaderSource& source) {
  Handle<DeleteShader> shader(glCreateShader(stage));
  const char* text = source.text.c_str();
  glShaderSource(shader.get(), 1, &text, nullptr);
  glCompileShader(shader.get());
  GLint good = GL_FALSE;
  glGetShaderiv(shader.get(), GL_COMPILE_STATUS, &good);
  if (good != GL_TRUE) {
    GLint length = 0;
    glGetShaderiv(shader.get(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetShaderInfoLog(shader.get(), length, nullptr, log.data());
    throw UserError(ExitCode::device,
                    fmt::format("simreel: error: the driver cannot compile glsl/{}:\n{}", path,
                                source.explain(log.c_str())),
                    UserError::Form::report);
  }
  return shader;
}

}  // namespace

void Program::link(const std::string& label) {
  label_ = label;
  glLinkProgram(name());
  GLint good = GL_FALSE;
  glGetProgramiv(name(), GL_LINK_STATUS, &good);
  if (good != GL_TRUE) {
    GLint length = 0;
    glGetProgramiv(name(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetProgramInfoLog(name(), length, nullptr, log.data());
    throw UserError(ExitCode::device,
                    fmt::format("simreel: error: the driver cannot link {}:\n{}", label, log.c_str()),
                    UserError::Form::report);
  }
  glObjectLabel(GL_PROGRAM, name(), -1, label.c_str());
}

Program Program::compute(const std::string& path, const Defines& defines) {
  return computeFrom(path, loadShader(path, defines));
}

Program Program::computeText(const std::string& name, const std::string& text, const Defines& defines) {
  return computeFrom(name, loadShaderText(name, text, defines));
}

Program Program::computeFrom(const std::string& path, const ShaderSource& source) {
  Program program;
  program.handle_ = Handle<DeleteProgram>(glCreateProgram());
  const auto shader = compile(GL_COMPUTE_SHADER, path, source);
  glAttachShader(program.name(), shader.get());
  program.link(path);
  glDetachShader(program.name(), shader.get());
  glGetProgramiv(program.name(), GL_COMPUTE_WORK_GROUP_SIZE, program.groupSize_);
  return program;
}

Program Program::graphics(const std::string& vertexPath, const std::string& fragmentPath,
                          const Defines& defines) {
  Program program;
  program.handle_ = Handle<DeleteProgram>(glCreateProgram());
  const auto vertex = compile(GL_VERTEX_SHADER, vertexPath, loadShader(vertexPath, defines));
  const auto fragment = compile(GL_FRAGMENT_SHADER, fragmentPath, loadShader(fragmentPath, defines));
  glAttachShader(program.name(), vertex.get());
  glAttachShader(program.name(), fragment.get());
  program.link(vertexPath + " + " + fragmentPath);
  glDetachShader(program.name(), vertex.get());
  glDetachShader(program.name(), fragment.get());
  return program;
}

void checkGroups(const std::string& label, int x, int y, const Limits& allowed) {
  if (x > allowed.groupsX || y > allowed.groupsY)
    fail(ExitCode::device,
         "{} needs {}x{} work groups, this device allows {}x{} (GL_MAX_COMPUTE_WORK_GROUP_COUNT)", label, x,
         y, allowed.groupsX, allowed.groupsY);
}

void Program::dispatch(int x, int y) const {
  if (x <= 0 || y <= 0) return;
  const GLint groupsX = (x - 1) / groupSize_[0] + 1;
  const GLint groupsY = (y - 1) / groupSize_[1] + 1;
  checkGroups(label_, groupsX, groupsY, limits());
  use();
  glDispatchCompute(static_cast<GLuint>(groupsX), static_cast<GLuint>(groupsY), 1);
}

GLint Program::location(const char* uniform) const {
  const auto found = locations_.find(uniform);
  if (found != locations_.end()) return found->second;
  const GLint place = glGetUniformLocation(name(), uniform);
  locations_.emplace(uniform, place);
  return place;
}

void Program::set(const char* uniform, int value) const {
  glProgramUniform1i(name(), location(uniform), value);
}
void Program::set(const char* uniform, unsigned value) const {
  glProgramUniform1ui(name(), location(uniform), value);
}
void Program::set(const char* uniform, float value) const {
  glProgramUniform1f(name(), location(uniform), value);
}
void Program::set(const char* uniform, const glm::ivec2& value) const {
  glProgramUniform2i(name(), location(uniform), value.x, value.y);
}
void Program::set(const char* uniform, const glm::ivec4& value) const {
  glProgramUniform4i(name(), location(uniform), value.x, value.y, value.z, value.w);
}
void Program::set(const char* uniform, const glm::vec2& value) const {
  glProgramUniform2f(name(), location(uniform), value.x, value.y);
}
void Program::set(const char* uniform, const glm::vec3& value) const {
  glProgramUniform3f(name(), location(uniform), value.x, value.y, value.z);
}
void Program::set(const char* uniform, const glm::vec4& value) const {
  glProgramUniform4f(name(), location(uniform), value.x, value.y, value.z, value.w);
}
void Program::set(const char* uniform, const glm::mat4& value) const {
  glProgramUniformMatrix4fv(name(), location(uniform), 1, GL_FALSE, &value[0][0]);
}

void Program::checkUniformBlock(const char* block, std::size_t bytes) const {
  const GLuint index = glGetUniformBlockIndex(name(), block);
  checkCalls();
  SIMREEL_CHECK(index != GL_INVALID_INDEX);
  GLint size = 0;
  glGetActiveUniformBlockiv(name(), index, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
  checkCalls();
  SIMREEL_CHECK_EQ(static_cast<std::size_t>(size), bytes);
}

}  // namespace simreel::gl
