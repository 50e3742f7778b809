#pragma once
#include "sim/core/simulation.hpp"

#include <vector>

namespace simreel::sim {

/// Returns the object kinds "box", "cylinder", "cone", "torus" and "disc": meshes of one shape.
[[nodiscard]] std::vector<SimulationKind> solidKinds();

}  // namespace simreel::sim
