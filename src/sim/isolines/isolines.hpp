#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the kind "isolines": lines of equal values over a displayed field, with numbers.
[[nodiscard]] SimulationKind isolinesKind();

}  // namespace simreel::sim
