#pragma once
#include "base/clock.hpp"
#include "gl/handle.hpp"
#include "gl/program_interface.hpp"
#include "gl/shader_source.hpp"
#include "gl/uniform.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace simreel::gl {

/// A linked OpenGL program. All Programs and Kernels of one context with the same source share it. It is
/// compiled and linked at its first use.
class LinkedProgram {
 public:
  struct Stage {
    GLenum type = GL_COMPUTE_SHADER;
    std::string path;  ///< path below glsl/, used in messages
    ShaderSource source;
  };

  /// Returns the shared program with these stages. The program exists until the context is destroyed.
  static std::shared_ptr<LinkedProgram> of(std::string label, std::vector<Stage> stages);
  /// Drops all programs. The context calls this function before it is destroyed.
  static void forgetAll();

  LinkedProgram(std::string label, std::vector<Stage> stages)
      : label_(std::move(label)), stages_(std::move(stages)) {}

  /// Compiles and links the program at the first call. Throws UserError(device) with file:line of the
  /// original files.
  void link();
  [[nodiscard]] bool linked() const { return static_cast<bool>(handle_); }
  [[nodiscard]] GLuint name() const { return handle_.get(); }
  [[nodiscard]] const std::string& label() const { return label_; }
  /// Returns the number of invocations of a workgroup in x, y and z. Requires link().
  [[nodiscard]] const GLint* groupSize() const { return groupSize_; }
  /// Returns the stages; empty after link().
  [[nodiscard]] const std::vector<Stage>& stages() const { return stages_; }

  /// Returns the Program or Kernel whose uniform values the linked program currently holds, or null.
  [[nodiscard]] const void* user() const { return user_; }
  /// Sets the uniform values of `user`, which must cover all active uniforms. Requires link().
  void giveTo(const void* user, std::vector<UniformSlot>& uniforms);
  /// Returns the interface that the driver reports. Requires link().
  [[nodiscard]] const ProgramInterface& interface() const { return interface_; }
  /// If `user` owns the current uniform values, clears the owner. Called before `user` is destroyed.
  void leave(const void* user) {
    if (user_ == user) user_ = nullptr;
  }

  /// Calls `run`, which dispatches this program as the current one. Measures the time of the first
  /// dispatch.
  template <class Run>
  void dispatch(const Run& run) {
    if (dispatched_) return run();
    const auto start = Clock::now();
    run();
    dispatched_ = true;
    firstDispatchTook(secondsSince(start));
  }
  /// True if the program has been dispatched, so that the driver has machine code for it.
  [[nodiscard]] bool dispatched() const { return dispatched_; }

 private:
  void firstDispatchTook(double seconds) const;
  /// Logs a slow compilation. When compilations add up to a second, prints a note to a terminal.
  void compiledFor(const char* what, double seconds) const;

  std::string label_;
  std::vector<Stage> stages_;  ///< empty after link()
  Handle<DeleteProgram> handle_;
  GLint groupSize_[3] = {1, 1, 1};
  const void* user_ = nullptr;
  ProgramInterface interface_;
  bool dispatched_ = false;
};

}  // namespace simreel::gl
