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

/// Light of sprites and spheres that add it, summed up in whole numbers of 64 bits, 24 bytes a pixel
/// (glsl/draw/instances/glow_block.glsl): the order does not matter.
class GlowRaster {
 public:
  static constexpr std::int64_t sumBytes = 24;  ///< of a pixel

  /// Those whose box has no side above `smallPixels` are summed up by an invocation each, of the others
  /// those of at most `mediumPixels` by a group, the rest by many.
  explicit GlowRaster(int samples, int smallPixels = smallGlow(), int mediumPixels = mediumBall());

  /// Makes room for a picture. Throws UserError(device) naming the limit where there is none.
  void prepare(glm::ivec2 size);
  /// Sums up what is before what is visible, ground included. The uniform blocks are bound.
  void draw(const std::vector<const sim::Instances*>& glows, const Visibility& picture);
  /// The sums, for other kernels that add.
  [[nodiscard]] const gl::Buffer& sums() const { return sums_; }
  /// Adds the sums to the light and empties them.
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
