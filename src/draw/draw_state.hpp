#pragma once
#include "gl/buffer.hpp"
#include "gl/errors.hpp"
#include "gl/handle.hpp"
#include "gl/program.hpp"
#include "sim/core/drawable.hpp"

#include <vector>

namespace simreel::draw {

/// Fixed-function state of a pass. Each pass sets all of it, so that no pass depends on the previous one.
struct DrawState {
  bool depthTest = true;
  bool cullBack = false;
  bool depthOffset = false;
  bool adding = false;  ///< additive blending; depth is tested but not written

  void set() const {
    const auto turn = [](GLenum what, bool on) { on ? glEnable(what) : glDisable(what); };
    turn(GL_DEPTH_TEST, depthTest);
    turn(GL_CULL_FACE, cullBack);
    turn(GL_POLYGON_OFFSET_FILL, depthOffset);
    turn(GL_MULTISAMPLE, true);
    turn(GL_PROGRAM_POINT_SIZE, true);
    turn(GL_BLEND, adding);
    for (const GLenum off : {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_FRAMEBUFFER_SRGB, GL_PRIMITIVE_RESTART,
                             GL_DEPTH_CLAMP, GL_SAMPLE_SHADING, GL_SAMPLE_ALPHA_TO_COVERAGE})
      glDisable(off);
    glDepthFunc(GL_LESS);
    glDepthMask(depthTest && !adding ? GL_TRUE : GL_FALSE);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glFrontFace(GL_CCW);
    glCullFace(GL_BACK);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  }
};

#include "glsl/draw/bindings.glsl"

/// A vertex array without attributes. Shaders fetch vertices by index, but OpenGL requires a vertex array
/// for drawing.
class VertexArray {
 public:
  VertexArray() : handle_(create()) {}
  void bind() const { glBindVertexArray(handle_.get()); }
  void bind(const gl::Buffer& indices) const {
    glVertexArrayElementBuffer(handle_.get(), indices.name());
    bind();
    gl::checkCalls();  // Reports an unset index buffer, because drivers would read from address 0 during
                       // the draw.
  }

 private:
  static GLuint create() {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return name;
  }
  gl::Handle<gl::DeleteVertexArray> handle_;
};

/// Returns the value of the uniform `rowOf` (see draw/exact/triangles/surface_triangle.glsl).
inline glm::ivec2 rowOf(const sim::Surface& surface) {
  return surface.rowIndices > 0 ? glm::ivec2(surface.rowIndices / 3, surface.grid.x) : glm::ivec2(0);
}

/// Draws all triangles of a surface from the bound vertex array.
inline void drawTriangles(const sim::Surface& surface) {
  if (surface.rowIndices > 0) {
    const auto rows = static_cast<std::size_t>(surface.grid.y - 1);
    const std::vector<GLsizei> counts(rows, surface.rowIndices);
    const std::vector<const void*> offsets(rows, nullptr);
    std::vector<GLint> firsts;
    for (int y = 0; y + 1 < surface.grid.y; ++y) firsts.push_back(y * surface.grid.x);
    glMultiDrawElementsBaseVertex(GL_TRIANGLES, counts.data(), GL_UNSIGNED_INT, offsets.data(),
                                  static_cast<GLsizei>(rows), firsts.data());
    return;
  }
  if (surface.arguments == nullptr) {
    glDrawElements(GL_TRIANGLES, surface.indexCount, GL_UNSIGNED_INT, nullptr);
    return;
  }
  glBindBuffer(GL_DRAW_INDIRECT_BUFFER, surface.arguments->name());
  glDrawElementsIndirect(GL_TRIANGLES, GL_UNSIGNED_INT, nullptr);
}

}  // namespace simreel::draw
