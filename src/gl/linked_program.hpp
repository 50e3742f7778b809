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

/// A program of the driver, shared by all Programs of one context that have the same source. It is compiled
/// and linked at its first use.
class LinkedProgram {
 public:
  struct Stage {
    GLenum type = GL_COMPUTE_SHADER;
    std::string path;  ///< below glsl/, for messages
    ShaderSource source;
  };

  /// Returns the shared program with these stages. It lives until the context ends.
  static std::shared_ptr<LinkedProgram> of(std::string label, std::vector<Stage> stages);
  /// Forgets all programs. The context calls it before it ends.
  static void forgetAll();

  LinkedProgram(std::string label, std::vector<Stage> stages)
      : label_(std::move(label)), stages_(std::move(stages)) {}

  /// Compiles and links unless that is done. Throws UserError(device) with file:line of the original files.
  void link();
  [[nodiscard]] bool linked() const { return static_cast<bool>(handle_); }
  [[nodiscard]] GLuint name() const { return handle_.get(); }
  [[nodiscard]] const std::string& label() const { return label_; }
  /// Invocations of a work group, by direction. Needs link().
  [[nodiscard]] const GLint* groupSize() const { return groupSize_; }
  /// The stages, until it is linked.
  [[nodiscard]] const std::vector<Stage>& stages() const { return stages_; }

  /// The Program whose uniform values it has; null for none.
  [[nodiscard]] const void* user() const { return user_; }
  /// Gives it the uniform values of `user`, which has set all that are active. Needs link().
  void giveTo(const void* user, std::vector<UniformSlot>& uniforms);
  /// Needs link().
  [[nodiscard]] const ProgramInterface& interface() const { return interface_; }
  /// Forgets `user`, whose values it may have.
  void leave(const void* user) {
    if (user_ == user) user_ = nullptr;
  }

  /// Calls `run`, which dispatches it as the current program.
  template <class Run>
  void dispatch(const Run& run) {
    if (dispatched_) return run();
    const auto start = Clock::now();
    run();
    dispatched_ = true;
    firstDispatchTook(secondsSince(start));
  }
  /// True once it has been dispatched, so that the driver has machine code for it.
  [[nodiscard]] bool dispatched() const { return dispatched_; }

 private:
  void firstDispatchTook(double seconds) const;
  /// Logs a slow compilation, and tells a terminal once they add up to a second.
  void compiledFor(const char* what, double seconds) const;

  std::string label_;
  std::vector<Stage> stages_;  ///< empty once it is linked
  Handle<DeleteProgram> handle_;
  GLint groupSize_[3] = {1, 1, 1};
  const void* user_ = nullptr;
  ProgramInterface interface_;
  bool dispatched_ = false;
};

}  // namespace simreel::gl
