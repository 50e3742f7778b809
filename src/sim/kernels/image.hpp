#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the kind "image": a picture that a user's shader computes pixel by pixel, as on ShaderToy.
[[nodiscard]] SimulationKind imageKind();

}  // namespace simreel::sim
