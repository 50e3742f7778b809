#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the simulation kind "particles": N-body particles, force fields and emitters on the GPU,
/// integrated by leapfrog, with 48 bytes per particle.
[[nodiscard]] SimulationKind particlesKind();

}  // namespace simreel::sim
