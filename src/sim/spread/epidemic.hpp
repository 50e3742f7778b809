#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Susceptible, infected and recovered people on a grid, two bytes a cell and 16 a step for the
/// counts.
[[nodiscard]] SimulationKind epidemicKind();

}  // namespace simreel::sim
