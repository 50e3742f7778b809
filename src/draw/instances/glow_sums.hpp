#pragma once
#include "draw/instances/instance_values.hpp"
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <glm/vec2.hpp>

namespace simreel::draw {

/// A level of additive sprites: fields of draw/instances/glow_sums.comp.
struct GlowFields {
  InstanceFields instance;
  InstanceLook look;
  ListFields listed;
  gl::Uniform<"roundPixels", float> roundPixels;
};

struct SumGlows;

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

  /// Adds up to `capacity` instances of level 0 or, `large`, of level 1, which may cover the whole picture.
  void add(bool large, const GlowFields& glows, const gl::Texture& depth, int capacity) const;

  /// Returns the sums, for a kernel that takes and empties them.
  [[nodiscard]] const gl::Buffer& sums() const { return sums_; }

 private:
  gl::Buffer sums_;
  gl::Kernel<SumGlows> small_, large_;
  static constexpr int slices = 8;  ///< of rows, that groups share of a large glow
};

}  // namespace simreel::draw
