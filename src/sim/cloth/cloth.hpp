#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Mass-spring cloth on the GPU (SPEC 1): a grid of particles, 48 bytes each beside the index buffer.
[[nodiscard]] SimulationKind clothKind();

}  // namespace simreel::sim
