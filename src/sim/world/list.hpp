#pragma once
#include "sim/core/simulation.hpp"

#include <memory>
#include <span>
#include <string_view>

namespace simreel::sim {

/// Returns all kinds of objects that a scene can have. A new kind of simulation needs one line in list.cpp.
[[nodiscard]] std::span<const SimulationKind> simulations();
/// Returns the kind with this name. The name must exist; the scene reader has checked it.
[[nodiscard]] const SimulationKind& simulationNamed(std::string_view kind);
/// Returns the kinds for the scene reader, together with the check of references between objects
/// (port_check.cpp).
[[nodiscard]] const scene::Kinds& kinds();

}  // namespace simreel::sim
