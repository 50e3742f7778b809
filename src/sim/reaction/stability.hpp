#pragma once
#include "sim/reaction/plan.hpp"

#include <optional>

namespace simreel::sim {

/// Growth of the fastest-growing small wave.
struct StepGrowth {
  double step = 1;  ///< Factor by which one step multiplies the wave's height.
  double equations =
      1;          ///< Factor by which the exact equations multiply the wave's height over the same time.
  double dt = 0;  ///< Step size, in units of time, that follows the equations.
};

/// Tests whether steps amplify small waves that the equations do not amplify. Samples three cells of the
/// initial state; each cell's values fill a small periodic grid of 4 cells per axis. Returns nothing if the
/// steps are stable, and always for meshes and automata.
[[nodiscard]] std::optional<StepGrowth> unstableSteps(const ReactionPlan& plan, const RulePlanes& first);

}  // namespace simreel::sim
