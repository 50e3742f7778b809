#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Continuous automata on the GPU: Lenia (Chan 2019) with several kernels, and SmoothLife (Rafler 2011).
[[nodiscard]] SimulationKind leniaKind();

}  // namespace simreel::sim
