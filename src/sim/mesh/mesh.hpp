#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

[[nodiscard]] SimulationKind meshKind();

}  // namespace simreel::sim
