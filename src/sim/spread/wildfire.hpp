#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the simulation kind "wildfire": a fire on a map of fuel, with four bytes per cell, and 16 bytes
/// per step for the counts.
[[nodiscard]] SimulationKind wildfireKind();

}  // namespace simreel::sim
