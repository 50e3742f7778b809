#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the simulation kind "arrows", which shows the velocities of another object as solid arrows.
[[nodiscard]] SimulationKind arrowsKind();

}  // namespace simreel::sim
