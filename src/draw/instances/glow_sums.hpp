#pragma once
#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Light of additive sprites, summed up by kernels in whole numbers of 64 bits
/// (glsl/draw/instances/glow_block.glsl), 24 bytes a pixel. Cards for computing blend slowly: they have few
/// of the units that do.
class GlowSums {
 public:
  /// Whether this device's sprites go this way: the storage path.
  [[nodiscard]] static bool used();
  /// Whether these instances go this way.
  [[nodiscard]] static bool takes(const sim::Instances& instances);

  /// Throws UserError(device) naming the limit when the device has no buffer for so many pixels.
  GlowSums(glm::ivec2 size, int samples);

  /// The kernels for level 0 and level 1 of sprites; `large` ones may cover the whole picture.
  [[nodiscard]] const gl::Program& kernel(bool large) const { return large ? large_ : small_; }
  /// Runs a kernel whose other uniforms and inputs are set, for up to `capacity` instances.
  void add(bool large, const gl::Texture& depth, int capacity) const;

  /// For a kernel that takes the sums and empties them.
  void bind() const;

 private:
  gl::Buffer sums_;
  gl::Program small_, large_;
  static constexpr int slices = 8;  ///< of rows, that groups share of a large glow
};

}  // namespace simreel::draw
