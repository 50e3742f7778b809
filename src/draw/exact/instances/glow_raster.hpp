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
/// (glsl/draw/instances/glow_block.glsl). The result does not depend on the order of the additions.
class GlowRaster {
 public:
  static constexpr std::int64_t sumBytes = 24;  ///< bytes per pixel

  /// One invocation handles a glow whose bounding box has at most `smallPixels` per side. One workgroup
  /// handles a medium glow, of at most `mediumPixels` per side. Many workgroups handle a larger glow.
  explicit GlowRaster(int samples, int smallPixels = smallGlow(), int mediumPixels = mediumBall());

  /// Sets whether haze dims the glows.
  void setHazy(bool hazy) { hazy_ = hazy; }
  /// Allocates the sums for a picture. Throws UserError(device), which names the limit, if a device limit
  /// is exceeded.
  void prepare(glm::ivec2 size);
  /// Sums the light of glows in front of the visible surfaces and the ground. The uniform blocks must be
  /// bound.
  void draw(const std::vector<const sim::Instances*>& glows, const Visibility& picture);
  /// Returns the sums, for other kernels that add light.
  [[nodiscard]] const gl::Buffer& sums() const { return sums_; }
  /// Adds the sums to `light` and resets the sums to 0.
  void addTo(glm::ivec2 size, const gl::Texture& light) const;

 private:
  [[nodiscard]] bool anyMedium() const { return mediumPixels_ > smallPixels_; }
  void run(bool large, const Visibility& picture);

  int samples_;
  int smallPixels_;
  int mediumPixels_;
  bool hazy_ = false;
  std::vector<const sim::Instances*> glows_;
  std::vector<InstanceColors> colors_;
  gl::Kernels<GlowKernel> kernels_;
  GroupCounts groups_;
  gl::Kernel<AddGlows> add_;
  gl::Buffer sums_, large_, counters_, largeGroups_;
  gl::Texture largeView_, counterView_;
};

}  // namespace simreel::draw
