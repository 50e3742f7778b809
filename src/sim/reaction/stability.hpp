#pragma once
#include "sim/reaction/plan.hpp"

#include <optional>

namespace simreel::sim {

/// How the fastest of all small waves grows.
struct StepGrowth {
  double step = 1;       ///< times a step
  double equations = 1;  ///< and in the same time by the equations alone
  double dt = 0;         ///< units of time: a step that is found to follow them
};

/// Whether steps make small waves grow that the equations do not, as far as three of the first state's
/// cells tell, each of them everywhere on a torus of 4 cells each way; nothing where they do not, and of
/// meshes and automata.
[[nodiscard]] std::optional<StepGrowth> unstableSteps(const ReactionPlan& plan, const RulePlanes& first);

}  // namespace simreel::sim
