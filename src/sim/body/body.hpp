#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

[[nodiscard]] SimulationKind bodyKind();

}  // namespace simreel::sim
