#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Cellular automata on the GPU: of two states one bit a cell, of more one byte; two buffers.
[[nodiscard]] SimulationKind lifeKind();

}  // namespace simreel::sim
