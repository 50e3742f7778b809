#include "gl/program.hpp"

#include "base/error.hpp"
#include "gl/buffer.hpp"
#include "gl/context.hpp"
#include "gl/errors.hpp"
#include "gl/limits.hpp"
#include "gl/linked_program.hpp"
#include "gl/rehearsal.hpp"
#include "gl/uniform.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

namespace simreel::gl {

namespace {

void checkBlock(GLuint program, const char* block, std::size_t bytes) {
  const GLuint index = glGetUniformBlockIndex(program, block);
  checkCalls();
  SIMREEL_CHECK(index != GL_INVALID_INDEX);
  GLint size = 0;
  glGetActiveUniformBlockiv(program, index, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
  checkCalls();
  SIMREEL_CHECK_EQ(static_cast<std::size_t>(size), bytes);
}

}  // namespace

/// Uniform values and checks of one Program, and the shared LinkedProgram.
struct Program::Own {
  explicit Own(std::shared_ptr<LinkedProgram> shared) : linked(std::move(shared)) {}
  ~Own() { linked->leave(this); }
  Own(Own&&) = delete;
  Own(const Own&) = delete;
  Own& operator=(Own&&) = delete;
  Own& operator=(const Own&) = delete;

  UniformSlot& uniform(const char* name, const UniformSlot::Value& value) {
    const auto found = std::find_if(uniforms.begin(), uniforms.end(),
                                    [&](const UniformSlot& one) { return one.name == name; });
    if (found != uniforms.end()) return *found;
    uniforms.push_back({name, value});
    return uniforms.back();
  }

  /// Throws UserError(device) unless each active uniform has been set. Otherwise a misspelt name would
  /// silently leave a uniform at 0.
  void checkUniforms() {
    if (checked) return;
    for (const auto& [whole, type] : linked->interface().numbers) {
      const std::string name = whole.substr(0, whole.find_first_of("[."));
      if (std::ranges::none_of(uniforms, [&](const UniformSlot& one) { return one.isPartOf(name); }))
        fail(ExitCode::device,
             "glsl/{} reads the uniform \"{}\", which the program never sets; check its spelling",
             linked->label(), name);
    }
    checked = true;
  }

  std::shared_ptr<LinkedProgram> linked;
  bool checked = false;  ///< true if checkUniforms() has passed
  std::vector<UniformSlot> uniforms;
  std::vector<std::pair<std::string, std::size_t>>
      blocks;  ///< names and sizes (bytes) of uniform blocks, checked after linking
};

Program::Program() = default;
Program::~Program() = default;
Program::Program(Program&&) noexcept = default;
Program& Program::operator=(Program&&) noexcept = default;
Program::Program(std::shared_ptr<LinkedProgram> linked) : own_(std::make_unique<Own>(std::move(linked))) {}

Program Program::compute(const std::string& path, const Defines& defines) {
  return Program(LinkedProgram::of(path, {{GL_COMPUTE_SHADER, path, loadShader(path, defines)}}));
}

Program Program::computeText(const std::string& name, const std::string& text, const Defines& defines) {
  return Program(LinkedProgram::of(name, {{GL_COMPUTE_SHADER, name, loadShaderText(name, text, defines)}}));
}

Program Program::graphics(const std::string& vertexPath, const std::string& fragmentPath,
                          const Defines& defines) {
  return Program(
      LinkedProgram::of(vertexPath + " + " + fragmentPath,
                        {{GL_VERTEX_SHADER, vertexPath, loadShader(vertexPath, defines)},
                         {GL_FRAGMENT_SHADER, fragmentPath, loadShader(fragmentPath, defines)}}));
}

void checkGroups(const std::string& label, int x, int y, const Limits& allowed) {
  if (x > allowed.groupsX || y > allowed.groupsY)
    fail(ExitCode::device,
         "{} needs {}x{} work groups, this device allows {}x{} (GL_MAX_COMPUTE_WORK_GROUP_COUNT)", label, x,
         y, allowed.groupsX, allowed.groupsY);
}

void Program::link() const {
  own_->linked->link();
  for (const auto& [block, bytes] : std::exchange(own_->blocks, {}))
    checkBlock(own_->linked->name(), block.c_str(), bytes);
}

GLuint Program::name() const {
  if (own_ == nullptr) return 0;
  link();
  return own_->linked->name();
}

void Program::use() const {
  link();
  LinkedProgram& linked = *own_->linked;
  own_->checkUniforms();
  if (linked.user() != own_.get()) linked.giveTo(own_.get(), own_->uniforms);
  glUseProgram(linked.name());
}

void Program::dispatch(int x, int y) const {
  if (x <= 0 || y <= 0) return;
  if (Rehearsal::note(own_->linked)) return;
  link();
  const GLint* size = own_->linked->groupSize();
  const GLint groupsX = (x - 1) / size[0] + 1;
  const GLint groupsY = (y - 1) / size[1] + 1;
  checkGroups(own_->linked->label(), groupsX, groupsY, limits());
  dispatchGroups(static_cast<GLuint>(groupsX), static_cast<GLuint>(groupsY), 1);
}

void Program::dispatchGroups(GLuint x, GLuint y, GLuint z) const {
  if (Rehearsal::note(own_->linked)) return;
  use();
  own_->linked->dispatch([&] { glDispatchCompute(x, y, z); });
}

void Program::dispatchIndirect(const Buffer& commands, std::size_t offset) const {
  if (Rehearsal::note(own_->linked)) return;
  // On software drivers, reads the group counts back and skips a command without groups. The readback takes
  // microseconds, but compiling machine code for a kernel takes up to half a second.
  if (softwareDriver() && !own_->linked->dispatched()) {
    std::array<GLuint, 3> groups{};
    commands.read(offset, std::as_writable_bytes(std::span(groups)));
    if (groups[0] == 0 || groups[1] == 0 || groups[2] == 0) return;
  }
  use();
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, commands.name());
  own_->linked->dispatch([&] { glDispatchComputeIndirect(static_cast<GLintptr>(offset)); });
}

template <class T>
void Program::assign(const char* uniform, const T& value) const {
  UniformSlot& one = own_->uniform(uniform, value);
  one.value = value;
  if (own_->linked->user() == own_.get()) one.putInto(own_->linked->name());
}

void Program::set(const char* uniform, int value) const {
  assign(uniform, value);
}
void Program::set(const char* uniform, unsigned value) const {
  assign(uniform, value);
}
void Program::set(const char* uniform, float value) const {
  assign(uniform, value);
}
void Program::set(const char* uniform, const glm::ivec2& value) const {
  assign(uniform, value);
}
void Program::set(const char* uniform, const glm::ivec4& value) const {
  assign(uniform, value);
}
void Program::set(const char* uniform, const glm::vec2& value) const {
  assign(uniform, value);
}
void Program::set(const char* uniform, const glm::vec3& value) const {
  assign(uniform, value);
}
void Program::set(const char* uniform, const glm::vec4& value) const {
  assign(uniform, value);
}
void Program::set(const char* uniform, const glm::mat4& value) const {
  assign(uniform, value);
}

void Program::checkUniformBlock(const char* block, std::size_t bytes) const {
  if (own_->linked->linked())
    checkBlock(own_->linked->name(), block, bytes);
  else
    own_->blocks.emplace_back(block, bytes);
}

}  // namespace simreel::gl
