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

/// A linked OpenGL program, shared by all Programs and Kernels of one context with the same source. It is
/// compiled and linked at its first use.
class LinkedProgram {
 public:
  struct Stage {
    GLenum type = GL_COMPUTE_SHADER;
    std::string path;  ///< path below glsl/, for messages
    ShaderSource source;
  };

  /// Returns the shared program with these stages. It lives until the context ends.
  static std::shared_ptr<LinkedProgram> of(std::string label, std::vector<Stage> stages);
  /// Drops all programs. The context calls this function before it ends.
  static void forgetAll();

  LinkedProgram(std::string label, std::vector<Stage> stages)
      : label_(std::move(label)), stages_(std::move(stages)) {}

  /// Compiles and links the program at the first call. Throws UserError(device) with file:line of the
  /// original files.
  void link();
  [[nodiscard]] bool linked() const { return static_cast<bool>(handle_); }
  [[nodiscard]] GLuint name() const { return handle_.get(); }
  [[nodiscard]] const std::string& label() const { return label_; }
  /// Number of invocations of a workgroup in x, y and z. Requires link().
  [[nodiscard]] const GLint* groupSize() const { return groupSize_; }
  /// The stages; empty after link().
  [[nodiscard]] const std::vector<Stage>& stages() const { return stages_; }

  /// The Program or Kernel whose uniform values are currently set; null if none.
  [[nodiscard]] const void* user() const { return user_; }
  /// Sets the uniform values of `user`, which must cover all active uniforms. Requires link().
  void giveTo(const void* user, std::vector<UniformSlot>& uniforms);
  /// Interface as the driver reports it. Requires link().
  [[nodiscard]] const ProgramInterface& interface() const { return interface_; }
  /// Clears `user` as the owner of the current uniform values, before it is destroyed.
  void leave(const void* user) {
    if (user_ == user) user_ = nullptr;
  }

  /// Calls `run`, which dispatches this program as the current one. Measures the first dispatch.
  template <class Run>
  void dispatch(const Run& run) {
    if (dispatched_) return run();
    const auto start = Clock::now();
    run();
    dispatched_ = true;
    firstDispatchTook(secondsSince(start));
  }
  /// True once the program has been dispatched, so that the driver has machine code for it.
  [[nodiscard]] bool dispatched() const { return dispatched_; }

 private:
  void firstDispatchTook(double seconds) const;
  /// Logs a slow compilation, and prints a note to a terminal once compilations add up to a second.
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
