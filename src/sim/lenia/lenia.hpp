#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the simulation kind "lenia": continuous automata on the GPU. They are Lenia (Chan 2019) with one
/// or several kernels, or SmoothLife (Rafler 2011).
[[nodiscard]] SimulationKind leniaKind();

}  // namespace simreel::sim
