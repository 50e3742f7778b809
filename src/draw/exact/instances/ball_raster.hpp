#pragma once
#include "draw/exact/group_counts.hpp"
#include "draw/exact/visibility.hpp"
#include "sim/core/drawable.hpp"

#include <vector>

namespace simreel::draw {

struct SmallBalls;
struct LargeBalls;
struct BallShadows;

/// Rasterizes balls (sprites and spheres). Traces one ray per sample in pictures, and draws discs into the
/// sun's shadow map. The result does not depend on the execution order.
class BallRaster {
 public:
  using Into = Target;
  /// One invocation rasterizes a ball whose bounding box has at most `smallPixels` (0 to 64) per side. One
  /// workgroup rasterizes a medium ball, of at most `mediumPixels` (up to 64) per side. Many workgroups
  /// rasterize a larger ball, tile by tile. The limits do not change the result. In the sun's map, balls
  /// are either small or large.
  BallRaster(Into into, int samples, int smallPixels = smallBall(), int mediumPixels = mediumBall());

  /// Writes depth keys into a buffer that may already contain other objects. The uniform blocks and, for
  /// shadow maps, the transform must be bound. The ids of balls[i] start at firstIds[i]; shadow maps have
  /// no ids.
  void drawNearest(const std::vector<const sim::Instances*>& balls, const std::vector<unsigned>& firstIds,
                   const Visibility& into, const MapPart& part = {});
  /// Writes the ids of the nearest balls. Call after all objects have written their keys.
  void drawIds(const Visibility& into);

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
