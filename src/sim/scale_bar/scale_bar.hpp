#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the kind "scaleBar": a bar of a round length, labelled with this length.
[[nodiscard]] SimulationKind scaleBarKind();

}  // namespace simreel::sim
