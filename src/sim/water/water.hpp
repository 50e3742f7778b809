#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Shallow water over a terrain.
[[nodiscard]] SimulationKind waterKind();

}  // namespace simreel::sim
