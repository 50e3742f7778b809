#pragma once
#include "gl/handle.hpp"
#include "gl/program.hpp"

namespace simreel::gl {

/// Leaves out dispatches by what the device itself has found, while the CPU waits for nothing: indirect
/// dispatches without groups cost a card some two microseconds each, left out like this one.
class Condition {
 public:
  Condition();

  /// What is dispatched from here on to `end` is left out if the indirect command at byte `offset` of the
  /// buffer `commands` has no groups now. Not to be nested. Whoever wrote the command has to have put
  /// GL_COMMAND_BARRIER_BIT. Leaves another program and vertex array in use.
  void begin(GLuint commands, GLintptr offset) const;
  void end() const;

 private:
  Program point_;
  Handle<DeleteQuery> query_;
  Handle<DeleteFramebuffer> nowhere_;
  Handle<DeleteVertexArray> vertices_;
};

}  // namespace simreel::gl
