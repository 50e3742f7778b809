#pragma once
#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"

#include <map>
#include <string>

namespace simreel::draw {

/// Sprites of few pixels: a kernel makes four words of each visible one, from which points or squares are
/// drawn. One memory for all instances and for both eye and light, 16 bytes a sprite: it is filled right
/// before each draw.
class SmallSprites {
 public:
  /// Whether the driver draws points as finely as triangles.
  [[nodiscard]] static bool points();

  enum class Use { ball, glow, shadow };
  /// `lighting`: defines of draw/surface/lighting.glsl, for balls.
  const gl::Program& kernel(Use use, const gl::Defines& lighting);
  const gl::Program& shader(Use use);
  /// Runs a kernel of kernel() whose other uniforms and inputs are set, for up to `capacity` sprites, and
  /// binds what shader() reads.
  void prepare(const gl::Program& kernel, int capacity);

 private:
  std::map<std::string, gl::Program> kernels_;
  std::map<Use, gl::Program> shaders_;
  gl::Buffer memory_;
  gl::Texture view_;
  int capacity_ = 0;
};

}  // namespace simreel::draw
