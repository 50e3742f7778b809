#pragma once
#include "sim/core/simulation.hpp"

#include <memory>

namespace simreel::sim {

/// Returns the simulation kind "cloth": a mesh if the parameters give one, otherwise a grid.
[[nodiscard]] SimulationKind clothKind();

}  // namespace simreel::sim
