#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the simulation kind "streamlines": lines along the flow of another object, computed for each
/// frame.
[[nodiscard]] SimulationKind streamlinesKind();

}  // namespace simreel::sim
