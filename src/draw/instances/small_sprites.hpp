#pragma once
#include "draw/instances/instance_values.hpp"
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"

#include <map>

namespace simreel::draw {

/// Uniforms, buffers and textures that draw/instances/small_sprites.comp declares, for one level of detail
/// of sprites.
struct SpriteFields {
  InstanceFields instance;
  InstanceLook look = {};        ///< colours; only used for balls and glows
  MaterialFields material = {};  ///< material; only used for balls
  ListFields listed;
};

struct PrepareSprites;

/// Draws sprites of a few pixels. A kernel writes four words for each visible sprite, from which a point or
/// square is drawn. The buffer (16 bytes per sprite) is shared by all instances and viewers, so it is
/// filled right before each draw.
class SmallSprites {
 public:
  /// True if the driver rasterizes points as precisely as triangles.
  [[nodiscard]] static bool points();

  enum class Use { ball, glow, shadow };
  struct Kind {
    Use use = Use::ball;
    bool reflective = false, translucent = false;  ///< reflective: true if the balls' material is
                                                   ///< reflective; translucent: true if it is translucent
  };
  /// `lighting`: defines of draw/surface/lighting.glsl, used for balls.
  explicit SmallSprites(const gl::Defines& lighting);
  const gl::Program& shader(Use use);
  /// Prepares up to `capacity` sprites and binds the inputs of shader().
  void prepare(const Kind& kind, const SpriteFields& all, int capacity);

 private:
  gl::Kernels<PrepareSprites> unlit_, lit_;
  std::map<Use, gl::Program> shaders_;
  gl::Buffer memory_;
  gl::Texture view_;
  int capacity_ = 0;
};

}  // namespace simreel::draw
