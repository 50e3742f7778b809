#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Returns the kind kernels: compute shaders of the user in Unity's .compute, HLSL or GLSL.
[[nodiscard]] SimulationKind kernelsKind();
/// Functions `check` and `make` for all kinds whose parameters are KernelsParameters.
void checkKernels(const scene::Object& object, const Setting& setting);
[[nodiscard]] std::unique_ptr<Simulation> makeKernels(const scene::Object& object, const Setting& setting);

}  // namespace simreel::sim
