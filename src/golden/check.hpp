#pragma once
#include "frame/image.hpp"
#include "golden/result.hpp"
#include "scene/scene.hpp"
#include "sim/world.hpp"

#include <span>
#include <vector>

namespace simreel::golden {

/// Evaluates the checks of a scene as its frames are made.
class Checker {
 public:
  /// Throws UserError(usage) for a check that names an object, array, component or quantity that the scene
  /// does not have, listing what there is. `testedFrames`: those at which frame() will be called.
  Checker(const scene::Scene& scene, const sim::World& world, std::span<const int> testedFrames);
  /// Frames, besides the tested ones, that some check wants; ascending.
  [[nodiscard]] std::vector<int> frames() const;
  /// The world stands at this frame and the picture shows it (null where no picture was drawn). Waits for
  /// the GPU and reads state back, only where a check of this frame needs it.
  void frame(int frame, const sim::World& world, const frame::Image* image);
  [[nodiscard]] const std::vector<CheckResult>& results() const;

 private:
  struct Pending;
  std::vector<scene::Check> checks_;
  std::vector<CheckResult> results_;
};

}  // namespace simreel::golden
