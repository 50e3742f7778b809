#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the kind "isolines", which draws lines of equal values, with numbers, over a displayed field.
[[nodiscard]] SimulationKind isolinesKind();

}  // namespace simreel::sim
