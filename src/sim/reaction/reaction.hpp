#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Equations of one's own on a grid: a plane of cells for each species. Publishes what is shown as a field,
/// and each species, called NAME.species, for files.
[[nodiscard]] SimulationKind reactionKind();

}  // namespace simreel::sim
