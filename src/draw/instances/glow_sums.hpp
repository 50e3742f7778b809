#pragma once
#include "draw/instances/instance_values.hpp"
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Uniforms, buffers and textures that draw/instances/glow_sums.comp declares, for one level of detail of
/// additive sprites.
struct GlowFields {
  InstanceFields instance;
  InstanceLook look;
  ListFields listed;
  gl::Uniform<"roundPixels", float> roundPixels;
};

struct SumGlows;

/// Sums the light of additive sprites in 64-bit integers with kernels
/// (glsl/draw/instances/glow_block.glsl). The sums take 24 bytes per pixel. Compute GPUs have few blending
/// units, so blending would be slow.
class GlowSums {
 public:
  /// True if this device uses this class: only on the storage path (gl::memoryPath()).
  [[nodiscard]] static bool used();
  /// True if this class sums the light of `instances`.
  [[nodiscard]] static bool takes(const sim::Instances& instances);

  /// Allocates the sums. Throws UserError(device), which names the limit, if they exceed the device's max
  /// buffer size.
  GlowSums(glm::ivec2 size, int samples);

  /// Adds the light of up to `capacity` instances. `large` selects level 1, whose sprites may cover the
  /// whole picture, instead of level 0.
  void add(bool large, const GlowFields& glows, const gl::Texture& depth, int capacity) const;

  /// Returns the sums, for a kernel that reads and clears them.
  [[nodiscard]] const gl::Buffer& sums() const { return sums_; }

 private:
  gl::Buffer sums_;
  gl::Kernel<SumGlows> small_, large_;
  static constexpr int slices = 8;  ///< number of horizontal slices of the picture; each slice of a large
                                    ///< glow is handled by a separate workgroup
};

}  // namespace simreel::draw
