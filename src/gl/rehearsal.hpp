#pragma once
#include "gl/bound_views.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace simreel::gl {

class LinkedProgram;
class Texture;

/// Scope in which dispatches are recorded with their bindings instead of run. Drawing a frame in this scope
/// lists the kernels of the frame within a few milliseconds. Only one object may exist at a time.
class Rehearsal {
 public:
  struct Kernel {
    std::shared_ptr<LinkedProgram> program;
    std::vector<BoundViews> uses;  ///< bindings of each recorded dispatch
  };

  Rehearsal();
  ~Rehearsal();
  Rehearsal(Rehearsal&&) = delete;
  Rehearsal(const Rehearsal&) = delete;
  Rehearsal& operator=(Rehearsal&&) = delete;
  Rehearsal& operator=(const Rehearsal&) = delete;

  /// Returns the recorded kernels that are not linked yet, in the order of their first use.
  [[nodiscard]] std::vector<Kernel> extractKernels() { return std::move(kernels_); }

  /// True while a rehearsal exists.
  [[nodiscard]] static bool now();
  /// Records a kernel before its dispatch. Returns false if there is no rehearsal, so the kernel must run.
  static bool note(const std::shared_ptr<LinkedProgram>& program);
  /// Records a dispatch with views that are passed by name instead of by unit.
  static bool note(const std::shared_ptr<LinkedProgram>& program, const BoundViews& given);
  /// Returns the textures and images that are bound in the current rehearsal.
  [[nodiscard]] static const BoundViews& bound();
  static void bound(GLuint unit, const Texture& texture);
  static void boundImage(GLuint unit, const Texture& texture, GLint level, GLenum access, GLenum format);

 private:
  std::vector<Kernel> kernels_;
  BoundViews bound_;
  int noted_ = 0;
};

}  // namespace simreel::gl
