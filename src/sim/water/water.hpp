#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the kind "water": shallow water over a terrain.
[[nodiscard]] SimulationKind waterKind();

}  // namespace simreel::sim
