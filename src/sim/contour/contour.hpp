#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the kind "contour": a field or a picture as a terraced solid, rebuilt every frame.
[[nodiscard]] SimulationKind contourKind();

}  // namespace simreel::sim
