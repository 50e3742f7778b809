#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the kind "fluid": incompressible flow with dye and heat on a grid, published as a field
/// (fluid/plan.hpp).
[[nodiscard]] SimulationKind fluidKind();

}  // namespace simreel::sim
