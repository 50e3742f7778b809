#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Outer-totalistic cellular automata on the GPU (SPEC 3), one bit a cell, two buffers.
[[nodiscard]] SimulationKind lifeKind();

}  // namespace simreel::sim
