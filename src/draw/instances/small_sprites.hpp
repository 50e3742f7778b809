#pragma once
#include "draw/instances/instance_values.hpp"
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"

#include <map>

namespace simreel::draw {

/// A level of sprites: fields of draw/instances/small_sprites.comp.
struct SpriteFields {
  InstanceFields instance;
  InstanceLook look = {};        ///< of balls and glows
  MaterialFields material = {};  ///< of balls
  ListFields listed;
};

struct PrepareSprites;

/// Sprites of few pixels: a kernel makes four words of each visible one, from which points or squares are
/// drawn. One memory for all instances and for both eye and light, 16 bytes a sprite: it is filled right
/// before each draw.
class SmallSprites {
 public:
  /// Whether the driver draws points as finely as triangles.
  [[nodiscard]] static bool points();

  enum class Use { ball, glow, shadow };
  struct Kind {
    Use use = Use::ball;
    bool reflective = false, translucent = false;  ///< balls of such a material
  };
  /// `lighting`: defines of draw/surface/lighting.glsl, for balls.
  explicit SmallSprites(const gl::Defines& lighting);
  const gl::Program& shader(Use use);
  /// Makes up to `capacity` sprites, and binds what shader() reads.
  void prepare(const Kind& kind, const SpriteFields& all, int capacity);

 private:
  gl::Kernels<PrepareSprites> unlit_, lit_;
  std::map<Use, gl::Program> shaders_;
  gl::Buffer memory_;
  gl::Texture view_;
  int capacity_ = 0;
};

}  // namespace simreel::draw
