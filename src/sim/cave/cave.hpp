#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Caves by a cellular automaton, as a map and as a solid.
[[nodiscard]] SimulationKind caveKind();

}  // namespace simreel::sim
