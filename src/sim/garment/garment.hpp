#pragma once
#include "sim/core/simulation.hpp"

#include <memory>

namespace simreel::sim {

/// Returns the simulation kind "cloth": a grid, or a mesh if the parameters name one.
[[nodiscard]] SimulationKind clothKind();

}  // namespace simreel::sim
