#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// A fire on a map of fuel, four bytes a cell and 16 a step for the counts.
[[nodiscard]] SimulationKind wildfireKind();

}  // namespace simreel::sim
