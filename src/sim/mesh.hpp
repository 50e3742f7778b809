#pragma once
#include "sim/simulation.hpp"

namespace simreel::sim {

[[nodiscard]] SimulationKind meshKind();

}  // namespace simreel::sim
