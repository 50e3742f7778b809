#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

[[nodiscard]] SimulationKind chartKind();

}  // namespace simreel::sim
