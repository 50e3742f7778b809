#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the kind "reaction": user-defined equations with one plane of cells per species. Publishes the
/// displayed value as a field, and each species as a field NAME.species for files.
[[nodiscard]] SimulationKind reactionKind();

}  // namespace simreel::sim
