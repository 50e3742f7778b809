#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the simulation kind "particles": N-body particles, fields and emitters on the GPU, integrated by
/// leapfrog, 48 bytes per particle.
[[nodiscard]] SimulationKind particlesKind();

}  // namespace simreel::sim
