#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the simulation kind "epidemic": susceptible, infected and recovered people on a grid, with two
/// bytes per cell, and 16 bytes per step for the counts.
[[nodiscard]] SimulationKind epidemicKind();

}  // namespace simreel::sim
