#pragma once
#include "sim/core/simulation.hpp"

#include <memory>
#include <span>
#include <string_view>

namespace simreel::sim {

/// Everything a scene's objects can be. A new simulation is one line of list.cpp.
[[nodiscard]] std::span<const SimulationKind> simulations();
/// The one of that name, which the scene reader has seen to: it is an invariant that there is one.
[[nodiscard]] const SimulationKind& simulationNamed(std::string_view kind);
/// The same as the scene reader wants it, with what objects of a scene need of each other (port_check.cpp).
[[nodiscard]] const scene::Kinds& kinds();

}  // namespace simreel::sim
