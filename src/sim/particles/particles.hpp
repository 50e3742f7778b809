#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// N-body particles, fields and emitters on the GPU: leapfrog, 48 bytes a particle.
[[nodiscard]] SimulationKind particlesKind();

}  // namespace simreel::sim
