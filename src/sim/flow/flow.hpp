#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the simulation kind "flow": velocities from a file or from expressions, which do not change.
[[nodiscard]] SimulationKind flowKind();

}  // namespace simreel::sim
