#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the simulation kind "life": cellular automata on the GPU, one bit per cell for two states, one
/// byte for more; double-buffered.
[[nodiscard]] SimulationKind lifeKind();

}  // namespace simreel::sim
