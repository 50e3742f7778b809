#pragma once
#include "sim/core/simulation.hpp"

namespace simreel::sim {

/// Compute shaders that a user wrote: Unity's .compute, HLSL or GLSL.
[[nodiscard]] SimulationKind kernelsKind();
/// `check` and `make` of kinds whose parameters are KernelsParameters.
void checkKernels(const scene::Object& object, const Setting& setting);
[[nodiscard]] std::unique_ptr<Simulation> makeKernels(const scene::Object& object, const Setting& setting);

}  // namespace simreel::sim
