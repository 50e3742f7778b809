#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the kind "scaleBar": a bar of a round length with its number.
[[nodiscard]] SimulationKind scaleBarKind();

}  // namespace simreel::sim
