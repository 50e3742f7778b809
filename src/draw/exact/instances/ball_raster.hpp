#pragma once
#include "draw/exact/group_counts.hpp"
#include "draw/exact/visibility.hpp"
#include "sim/core/drawable.hpp"

#include <vector>

namespace simreel::draw {

struct SmallBalls;
struct LargeBalls;
struct BallShadows;

/// Finds where balls are nearest: sprites and spheres, by ray at every sample; or their discs on the sun's
/// map. The result does not depend on the order in which the device works.
class BallRaster {
 public:
  using Into = Target;
  /// Balls whose box has no side above `smallPixels` (0 to 64) are drawn by an invocation each, of the
  /// others those of at most `mediumPixels` (to 64) by a group, the rest by many, tile by tile: the same
  /// either way. Into the sun's map there are none of medium size.
  BallRaster(Into into, int samples, int smallPixels = smallBall(), int mediumPixels = mediumBall());

  /// What is nearest, into what is cleared or drawn already. The uniform blocks, and for a map the light's
  /// place, are bound. Numbers of balls[i] begin with firstIds[i]; maps have none.
  void drawNearest(const std::vector<const sim::Instances*>& balls, const std::vector<unsigned>& firstIds,
                   const Visibility& into, const MapPart& part = {});
  /// The numbers of those that are nearest when all is drawn.
  void drawNumbers(const Visibility& into);

 private:
  [[nodiscard]] bool anyMedium() const { return into_ != Into::sunMap && mediumPixels_ > smallPixels_; }
  void prepare();
  void run(bool large, int pass, const Visibility& into, const MapPart& part = {});

  Into into_;
  int samples_;
  int smallPixels_;
  int mediumPixels_;
  std::vector<const sim::Instances*> balls_;
  std::vector<unsigned> firstIds_;
  gl::Kernels<SmallBalls> smallBalls_;
  gl::Kernels<LargeBalls> largeBalls_;
  gl::Kernels<BallShadows> shadows_;
  GroupCounts groups_;
  gl::Buffer large_, counters_, largeGroups_;
  gl::Texture largeView_, counterView_;
};

}  // namespace simreel::draw
