#pragma once
#include "draw/instances/instance_values.hpp"
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Uniforms, buffers and textures that draw/instances/glow_sums.comp declares, for one level of additive
/// sprites.
struct GlowFields {
  InstanceFields instance;
  InstanceLook look;
  ListFields listed;
  gl::Uniform<"roundPixels", float> roundPixels;
};

struct SumGlows;

/// Sums the light of additive sprites in 64-bit integers with kernels
/// (glsl/draw/instances/glow_block.glsl), 24 bytes per pixel. Compute GPUs blend slowly because they have
/// few blending units.
class GlowSums {
 public:
  /// True if this device sums sprites in this way: on the storage path.
  [[nodiscard]] static bool used();
  /// True if these instances are summed in this way.
  [[nodiscard]] static bool takes(const sim::Instances& instances);

  /// Throws UserError(device), which names the limit, if the device has no buffer for that many pixels.
  GlowSums(glm::ivec2 size, int samples);

  /// Adds up to `capacity` instances of level 0 or, if `large`, of level 1, which may cover the whole
  /// picture.
  void add(bool large, const GlowFields& glows, const gl::Texture& depth, int capacity) const;

  /// Returns the sums, for a kernel that reads and clears them.
  [[nodiscard]] const gl::Buffer& sums() const { return sums_; }

 private:
  gl::Buffer sums_;
  gl::Kernel<SumGlows> small_, large_;
  static constexpr int slices = 8;  ///< number of slices of rows in which workgroups share a large glow
};

}  // namespace simreel::draw
