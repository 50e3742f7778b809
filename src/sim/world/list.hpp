#pragma once
#include "sim/core/simulation.hpp"

#include <memory>
#include <span>

namespace simreel::sim {

/// Everything a scene's objects can be. A new simulation is one line of list.cpp.
[[nodiscard]] std::span<const SimulationKind> simulations();
/// The same as the scene reader wants it.
[[nodiscard]] std::span<const scene::Kind> kinds();

}  // namespace simreel::sim
