#pragma once
#include "gl/bound_views.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace simreel::gl {

class LinkedProgram;
class Texture;

/// While one exists, kernels are not run: it notes which would have run, and what was bound. Drawing a
/// frame so tells the kernels of the frame in a few milliseconds. One at a time.
class Rehearsal {
 public:
  struct Kernel {
    std::shared_ptr<LinkedProgram> program;
    std::vector<BoundViews> uses;  ///< what was bound, each time that it would have run
  };

  Rehearsal();
  ~Rehearsal();
  Rehearsal(Rehearsal&&) = delete;
  Rehearsal(const Rehearsal&) = delete;
  Rehearsal& operator=(Rehearsal&&) = delete;
  Rehearsal& operator=(const Rehearsal&) = delete;

  /// The kernels that are not linked yet, in the order of their first use.
  [[nodiscard]] std::vector<Kernel> take() { return std::move(kernels_); }

  /// True while a rehearsal exists.
  [[nodiscard]] static bool now();
  /// Notes a kernel that is about to run. False where there is no rehearsal, so that it has to run.
  static bool note(const std::shared_ptr<LinkedProgram>& program);
  /// Notes a dispatch whose views are given by name instead of by unit.
  static bool note(const std::shared_ptr<LinkedProgram>& program, const BoundViews& given);
  /// The textures and images that are bound, while a rehearsal exists.
  [[nodiscard]] static const BoundViews& bound();
  static void bound(GLuint unit, const Texture& texture);
  static void boundImage(GLuint unit, const Texture& texture, GLint level, GLenum access, GLenum format);

 private:
  std::vector<Kernel> kernels_;
  BoundViews bound_;
  int noted_ = 0;
};

}  // namespace simreel::gl
