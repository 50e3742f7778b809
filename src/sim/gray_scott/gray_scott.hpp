#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Gray-Scott reaction-diffusion on the GPU: a torus of cells, 16 bytes each. Publishes v as a
/// field, and u, called NAME.u, for files.
[[nodiscard]] SimulationKind grayScottKind();

}  // namespace simreel::sim
