#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Any field, or a picture, as a solid with terraces, in every frame.
[[nodiscard]] SimulationKind contourKind();

}  // namespace simreel::sim
