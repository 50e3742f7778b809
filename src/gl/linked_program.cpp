#include "gl/linked_program.hpp"

#include "base/error.hpp"
#include "base/hash.hpp"
#include "base/log.hpp"
#include "gl/kernel_compiler.hpp"

#include <algorithm>
#include <unistd.h>
#include <unordered_map>
#include <utility>

namespace simreel::gl {

namespace {

/// Returns the programs of the current context by the hash of their stages. The map is never destroyed,
/// because a context that exists until the process exits may be destroyed after static objects.
std::unordered_map<std::string, std::shared_ptr<LinkedProgram>>& store() {
  static auto& programs = *new std::unordered_map<std::string, std::shared_ptr<LinkedProgram>>();
  return programs;
}

Handle<DeleteShader> compile(const LinkedProgram::Stage& stage) {
  Handle<DeleteShader> shader(glCreateShader(stage.type));
  const char* text = stage.source.text.c_str();
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
                    fmt::format("simreel: error: the driver cannot compile glsl/{}:\n{}", stage.path,
                                stage.source.explain(log.c_str())),
                    UserError::Form::report);
  }
  return shader;
}

}  // namespace

std::shared_ptr<LinkedProgram> LinkedProgram::of(std::string label, std::vector<Stage> stages) {
  std::string key;
  for (const Stage& stage : stages) key += hashHex(stage.source.text);
  std::shared_ptr<LinkedProgram>& program = store()[key];
  if (!program) program = std::make_shared<LinkedProgram>(std::move(label), std::move(stages));
  return program;
}

void LinkedProgram::forgetAll() {
  store().clear();
}

void LinkedProgram::firstDispatchTook(double seconds) const {
  KernelCompiler::dispatched(seconds);
  compiledFor("dispatch first", seconds);
}

void LinkedProgram::compiledFor(const char* what, double seconds) const {
  constexpr double fromCache = 0.005;
  if (seconds > fromCache) detail("shaders: {} took {:.0f} ms to {}", label_, 1000 * seconds, what);
  static double total = 0;
  static bool warned = false;
  if (seconds > fromCache) total += seconds;
  if (total < 1 || std::exchange(warned, true)) return;
  if (::isatty(STDERR_FILENO) != 0)
    info("the driver is compiling shaders, which takes some seconds the first time; later runs reuse them");
}

void LinkedProgram::giveTo(const void* user, std::vector<UniformSlot>& uniforms) {
  for (UniformSlot& one : uniforms) one.putInto(name());
  user_ = user;
}

void LinkedProgram::link() {
  if (linked()) return;
  KernelCompiler::claim(*this);
  const auto start = Clock::now();
  std::vector<Handle<DeleteShader>> shaders;
  for (const Stage& stage : stages_) shaders.push_back(compile(stage));
  Handle<DeleteProgram> program(glCreateProgram());
  for (const auto& shader : shaders) glAttachShader(program.get(), shader.get());
  glLinkProgram(program.get());
  GLint good = GL_FALSE;
  glGetProgramiv(program.get(), GL_LINK_STATUS, &good);
  if (good != GL_TRUE) {
    GLint length = 0;
    glGetProgramiv(program.get(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    glGetProgramInfoLog(program.get(), length, nullptr, log.data());
    throw UserError(ExitCode::device,
                    fmt::format("simreel: error: the driver cannot link {}:\n{}", label_, log.c_str()),
                    UserError::Form::report);
  }
  glObjectLabel(GL_PROGRAM, program.get(), -1, label_.c_str());
  for (const auto& shader : shaders) glDetachShader(program.get(), shader.get());
  if (stages_.front().type == GL_COMPUTE_SHADER)
    glGetProgramiv(program.get(), GL_COMPUTE_WORK_GROUP_SIZE, groupSize_);
  interface_ = ProgramInterface::of(program.get());
  handle_ = std::move(program);
  stages_.clear();
  const double seconds = secondsSince(start);
  KernelCompiler::linked(seconds);
  compiledFor("link", seconds);
}

}  // namespace simreel::gl
