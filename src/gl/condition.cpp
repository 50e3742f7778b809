#include "gl/condition.hpp"

namespace simreel::gl {

Condition::Condition() : point_(Program::graphics("common/point.vert", "common/point.frag")) {
  GLuint name = 0;
  glCreateQueries(GL_ANY_SAMPLES_PASSED, 1, &name);
  query_ = Handle<DeleteQuery>(name);
  glCreateFramebuffers(1, &name);
  nowhere_ = Handle<DeleteFramebuffer>(name);
  glNamedFramebufferParameteri(name, GL_FRAMEBUFFER_DEFAULT_WIDTH, 1);
  glNamedFramebufferParameteri(name, GL_FRAMEBUFFER_DEFAULT_HEIGHT, 1);
  glNamedFramebufferDrawBuffer(name, GL_NONE);
  glCreateVertexArrays(1, &name);
  vertices_ = Handle<DeleteVertexArray>(name);
}

// Draws points. Uses the indirect dispatch command as an indirect draw command, so the group counts x and y
// become the vertex count and the instance count. The occlusion query passes if at least one point is
// drawn.
void Condition::begin(GLuint commands, GLintptr offset) const {
  GLint before = 0, viewport[4] = {};
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &before);
  glGetIntegerv(GL_VIEWPORT, viewport);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, nowhere_.get());
  glViewport(0, 0, 1, 1);
  glBindVertexArray(vertices_.get());
  point_.use();
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commands);
  glBeginQuery(GL_ANY_SAMPLES_PASSED, query_.get());
  // NOLINTNEXTLINE(performance-no-int-to-ptr): OpenGL takes an offset for a pointer.
  glDrawArraysIndirect(GL_POINTS, reinterpret_cast<const void*>(offset));
  glEndQuery(GL_ANY_SAMPLES_PASSED);
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(before));
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  glBeginConditionalRender(query_.get(), GL_QUERY_WAIT);
}

void Condition::end() const {
  glEndConditionalRender();
}

}  // namespace simreel::gl
