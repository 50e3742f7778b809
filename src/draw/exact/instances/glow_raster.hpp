#pragma once
#include "draw/exact/group_counts.hpp"
#include "draw/exact/visibility.hpp"
#include "draw/instances/instance_values.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <cstdint>
#include <vector>

namespace simreel::draw {

struct GlowKernel;
struct AddGlows;

/// Sums the light of additive sprites and spheres in 64-bit integers, 24 bytes per pixel
/// (glsl/draw/instances/glow_block.glsl). The result does not depend on the order.
class GlowRaster {
 public:
  static constexpr std::int64_t sumBytes = 24;  ///< bytes of the sums per pixel

  /// Glows with a box of at most `smallPixels` per side are handled by one invocation each, medium ones of
  /// at most `mediumPixels` by one workgroup, larger ones by many workgroups.
  explicit GlowRaster(int samples, int smallPixels = smallGlow(), int mediumPixels = mediumBall());

  /// Allocates the sums of a picture. Throws UserError(device), which names the limit, if the device has no
  /// room.
  void prepare(glm::ivec2 size);
  /// Sums the light in front of the visible surfaces, including the ground. The uniform blocks must be
  /// bound.
  void draw(const std::vector<const sim::Instances*>& glows, const Visibility& picture);
  /// Returns the sums, for other kernels that add light.
  [[nodiscard]] const gl::Buffer& sums() const { return sums_; }
  /// Adds the sums to the light and clears them.
  void addTo(glm::ivec2 size, const gl::Texture& light) const;

 private:
  [[nodiscard]] bool anyMedium() const { return mediumPixels_ > smallPixels_; }
  void run(bool large, const Visibility& picture);

  int samples_;
  int smallPixels_;
  int mediumPixels_;
  std::vector<const sim::Instances*> glows_;
  std::vector<InstanceColors> colors_;
  gl::Kernels<GlowKernel> kernels_;
  GroupCounts groups_;
  gl::Kernel<AddGlows> add_;
  gl::Buffer sums_, large_, counters_, largeGroups_;
  gl::Texture largeView_, counterView_;
};

}  // namespace simreel::draw
