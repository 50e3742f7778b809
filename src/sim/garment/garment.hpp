#pragma once
#include "sim/core/simulation.hpp"

#include <memory>

namespace simreel::sim {

/// Cloth of a grid, or of a mesh where its parameters name one.
[[nodiscard]] SimulationKind clothKind();

}  // namespace simreel::sim
