#pragma once
#include "sim/reaction/plan.hpp"

#include <optional>

namespace simreel::sim {

/// Growth of the small perturbation wave that grows fastest.
struct StepGrowth {
  double step = 1;  ///< Factor by which one step multiplies the wave's height.
  double equations =
      1;          ///< Factor by which the exact equations multiply the wave's height over the same time.
  double dt = 0;  ///< Step size, in units of time, that is small enough for the steps to follow the
                  ///< equations.
};

/// Tests whether the steps amplify small waves that the equations do not amplify. Takes three cells of the
/// initial state as samples; the values of each sample fill a small periodic grid of 4 cells per axis.
/// Returns nothing if the steps are stable, and for all meshes and automata.
[[nodiscard]] std::optional<StepGrowth> unstableSteps(const ReactionPlan& plan, const RulePlanes& first);

}  // namespace simreel::sim
