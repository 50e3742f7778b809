#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Compute shaders that a user wrote: Unity's .compute, HLSL or GLSL.
[[nodiscard]] SimulationKind kernelsKind();

}  // namespace simreel::sim
