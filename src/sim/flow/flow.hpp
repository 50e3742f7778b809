#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the simulation kind "flow": constant velocities from a file or from expressions.
[[nodiscard]] SimulationKind flowKind();

}  // namespace simreel::sim
