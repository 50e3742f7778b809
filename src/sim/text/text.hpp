#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

[[nodiscard]] SimulationKind textKind();

}  // namespace simreel::sim
