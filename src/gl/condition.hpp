#pragma once
#include "gl/handle.hpp"
#include "gl/program.hpp"

namespace simreel::gl {

/// Skips dispatches depending on a GPU-side result, without making the CPU wait. Even without this class,
/// an indirect dispatch with zero groups costs a graphics card about two microseconds. A dispatch that this
/// class skips costs about one.
class Condition {
 public:
  Condition();

  /// Skips all dispatches until end() if the indirect command at byte `offset` of the buffer `commands` has
  /// zero groups at this point. Must not be nested. The caller must have issued GL_COMMAND_BARRIER_BIT
  /// after the command was written. Changes the current program and vertex array.
  void begin(GLuint commands, GLintptr offset) const;
  void end() const;

 private:
  Program point_;
  Handle<DeleteQuery> query_;
  Handle<DeleteFramebuffer> nowhere_;
  Handle<DeleteVertexArray> vertices_;
};

}  // namespace simreel::gl
