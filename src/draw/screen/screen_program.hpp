#pragma once
#include "draw/draw_state.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/give.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

#include <string>

namespace simreel::draw {

/// A texture that a ScreenProgram writes and other passes read.
struct ScreenTarget {
  ScreenTarget() = default;
  /// Creates the texture. Reads beyond the texture's border return the nearest border texel.
  ScreenTarget(const char* label, GLenum format, glm::ivec2 size);
  gl::Texture texture;
  gl::Framebuffer framebuffer;
};

/// Uniforms, buffers and textures that glsl/draw/screen/screen.glsl declares. ScreenProgram sets them.
struct ScreenFields {
  gl::Out<"target"> target = {};
};
struct ScreenVariant {
  gl::Code<"KERNEL", "rgba16f"> layout = {};
};

/// A program that computes every pixel of a target (glsl/draw/screen/screen.glsl). On the storage path the
/// program is a kernel, because compute GPUs rasterize with few of their processors and write pixels
/// slowly. On the texel path it draws a full-screen triangle, because software drivers write images slowly.
/// The interface must have a member `screen` of type ScreenFields, and its variant a member of type
/// ScreenVariant.
template <class Interface>
class ScreenProgram {
 public:
  using Variant = typename Interface::Variant;
  ScreenProgram() = default;
  /// `layout`: format qualifier of the target in GLSL. `vertices`: vertex shader of the full-screen
  /// triangle.
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
