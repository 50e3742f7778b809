#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Pictures that a user's shader computes pixel by pixel, as ShaderToy's do.
[[nodiscard]] SimulationKind imageKind();

}  // namespace simreel::sim
