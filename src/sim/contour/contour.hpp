#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the kind "contour", which shows a field or an image as a terraced solid that is rebuilt in every
/// frame.
[[nodiscard]] SimulationKind contourKind();

}  // namespace simreel::sim
