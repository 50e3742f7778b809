#pragma once
#include "scene/scene.hpp"
#include "sim/core/simulation.hpp"

#include <filesystem>
#include <vector>

namespace simreel::sim {

/// Returns the shader files of a scene's objects and their includes. For a shader that does not compile,
/// returns the files of its last successful compilation.
[[nodiscard]] std::vector<std::filesystem::path> shaderFiles(const scene::Scene& scene);

/// Returns the object kind "kernels": a user's compute shader (Unity .compute, HLSL or GLSL).
[[nodiscard]] SimulationKind kernelsKind();
/// Functions for SimulationKind::check and SimulationKind::make, for all kinds whose parameters are
/// KernelsParameters.
void checkKernels(const scene::Object& object, const Setting& setting);
[[nodiscard]] std::unique_ptr<Simulation> makeKernels(const scene::Object& object, const Setting& setting);

}  // namespace simreel::sim
