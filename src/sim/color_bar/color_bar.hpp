#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

[[nodiscard]] SimulationKind colorBarKind();

}  // namespace simreel::sim
