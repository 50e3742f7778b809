#pragma once
#include "draw/draw_state.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/give.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

#include <string>

namespace simreel::draw {

/// A picture that a ScreenProgram fills and others read.
struct ScreenTarget {
  ScreenTarget() = default;
  /// Reads beyond the border find the border.
  ScreenTarget(const char* label, GLenum format, glm::ivec2 size);
  gl::Texture texture;
  gl::Framebuffer framebuffer;
};

/// Fields of glsl/draw/screen/screen.glsl, which a ScreenProgram gives.
struct ScreenFields {
  gl::Out<"target"> target = {};
};
struct ScreenVariant {
  gl::Code<"KERNEL", "rgba16f"> layout = {};
};

/// A program for every pixel of a target (glsl/draw/screen/screen.glsl): a kernel on the storage path,
/// since cards for computing draw triangles with few of their processors and write pixels slowly; a
/// triangle on the texel path, since software drivers store to images slowly. The interface has a member
/// `screen`, which is ScreenFields, and its variant one, which is ScreenVariant.
template <class Interface>
class ScreenProgram {
 public:
  using Variant = typename Interface::Variant;
  ScreenProgram() = default;
  /// `layout`: the target's format as GLSL spells it. `vertices`: of the triangle.
  explicit ScreenProgram(const char* layout, Variant variant = {}, const gl::Defines& common = {},
                         const char* vertices = "draw/screen/screen.vert") {
    if (gl::memoryPath() == gl::MemoryPath::storage) {
      variant.screen.layout = std::string(layout);
      kernel_ = gl::Kernel<Interface>(common, variant);
      return;
    }
    triangle_ = gl::Program::graphics(vertices, Interface::file, gl::with(common, variant));
    gl::checkBlocks<Interface>(triangle_);
  }
  void fill(const gl::Texture& texture, const gl::Framebuffer& framebuffer, Interface given) const {
    if (kernel_) {
      given.screen.target = texture;
      kernel_.dispatch({texture.width(), texture.height()}, given);
      gl::barrier(GL_FRAMEBUFFER_BARRIER_BIT);
      return;
    }
    DrawState{.depthTest = false}.set();
    framebuffer.bind();
    gl::give(triangle_, given);
    triangle_.use();
    vertices_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  void fill(const ScreenTarget& target, const Interface& given) const {
    fill(target.texture, target.framebuffer, given);
  }

 private:
  gl::Kernel<Interface> kernel_;
  gl::Program triangle_;
  VertexArray vertices_;
};

}  // namespace simreel::draw
