#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the kind "grayScott": Gray-Scott reaction-diffusion on the GPU on a periodic grid. Publishes v
/// as a field, and u as a field NAME.u for files.
[[nodiscard]] SimulationKind grayScottKind();

}  // namespace simreel::sim
