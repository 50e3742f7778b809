#pragma once
#include "draw/exact/group_counts.hpp"
#include "draw/exact/visibility.hpp"
#include "draw/instances/instance_values.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

namespace simreel::draw {

/// Light of sprites and spheres that add it, summed up in whole numbers of 64 bits, 24 bytes a pixel
/// (glsl/draw/instances/glow_block.glsl): the order does not matter.
class GlowRaster {
 public:
  static constexpr std::int64_t sumBytes = 24;  ///< of a pixel

  /// Those whose box has no side above `smallPixels` are summed up by an invocation each, of the others
  /// those of at most `mediumPixels` by a group, the rest by many.
  explicit GlowRaster(int samples, int smallPixels = smallGlow(), int mediumPixels = mediumBall())
      : samples_(samples), smallPixels_(smallPixels), mediumPixels_(mediumPixels) {}

  /// Makes room for a picture. Throws UserError(device) naming the limit where there is none.
  void prepare(glm::ivec2 size);
  /// Sums up what is before what is visible, ground included. The uniform blocks are bound.
  void draw(const std::vector<const sim::Instances*>& glows, const Visibility& picture);
  /// Binds the sums for other kernels that add.
  void bindSums() const;
  /// Adds the sums to the bound light and empties them.
  void addTo(glm::ivec2 size) const;

 private:
  [[nodiscard]] bool anyMedium() const { return mediumPixels_ > smallPixels_; }
  const gl::Program& program(bool large, bool ball, SampleKind layout);
  void run(bool large, const Visibility& picture);

  int samples_;
  int smallPixels_;
  int mediumPixels_;
  std::vector<const sim::Instances*> glows_;
  std::vector<InstanceColors> colors_;
  std::map<std::tuple<bool, bool, SampleKind>, gl::Program> programs_;
  GroupCounts groups_;
  gl::Program add_;
  gl::Buffer sums_, large_, counters_, largeGroups_;
  gl::Texture largeView_, counterView_;
};

}  // namespace simreel::draw
