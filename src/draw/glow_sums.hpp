#pragma once
#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "sim/drawable.hpp"

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Light of additive sprites, summed up by kernels in whole numbers (glsl/draw/glow_block.glsl), 12 bytes a
/// pixel. Blending takes a card for computing twenty times as long, and its order would have to be kept.
class GlowSums {
 public:
  /// Whether this device's sprites go this way: the storage path.
  [[nodiscard]] static bool used();
  /// Whether these instances go this way.
  [[nodiscard]] static bool takes(const sim::Instances& instances);

  GlowSums(glm::ivec2 size, int samples);

  /// Chooses the scale, so that no sum runs over even if all glows of all crowds lie over each other.
  void start(const sim::Drawables& drawables);
  /// The kernels for level 0 and level 1 of sprites; `large` ones may cover the whole picture.
  [[nodiscard]] const gl::Program& kernel(bool large) const { return large ? large_ : small_; }
  /// Runs a kernel whose other uniforms and inputs are set, for up to `capacity` instances.
  void add(bool large, const gl::Texture& depth, int capacity) const;

  /// For a kernel that takes the sums and empties them.
  void bind(const gl::Program& program) const;

 private:
  gl::Buffer sums_;
  gl::Program small_, large_;
  static constexpr int slices = 8;  ///< of rows, that groups share of a large glow
  float scale_ = 1;
};

}  // namespace simreel::draw
