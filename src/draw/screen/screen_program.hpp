#pragma once
#include "draw/draw_state.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"

namespace simreel::draw {

/// A picture that a ScreenProgram fills and others read.
struct ScreenTarget {
  ScreenTarget() = default;
  /// Reads beyond the border find the border.
  ScreenTarget(const char* label, GLenum format, glm::ivec2 size);
  gl::Texture texture;
  gl::Framebuffer framebuffer;
};

/// A program for every pixel of a target (glsl/draw/screen/screen.glsl): a kernel on the storage path,
/// since cards for computing draw triangles with few of their processors and write pixels slowly; a
/// triangle on the texel path, since software drivers store to images slowly.
class ScreenProgram {
 public:
  ScreenProgram() = default;
  /// `layout`: the target's format as GLSL spells it. `vertices`: of the triangle.
  ScreenProgram(const char* path, const char* layout, gl::Defines defines = {},
                const char* vertices = "draw/screen/screen.vert");
  /// For its uniforms.
  [[nodiscard]] const gl::Program& program() const { return program_; }
  void fill(const gl::Texture& texture, const gl::Framebuffer& framebuffer) const;
  void fill(const ScreenTarget& target) const { fill(target.texture, target.framebuffer); }

 private:
  gl::Program program_;
  bool kernel_ = false;
  VertexArray vertices_;
};

}  // namespace simreel::draw
