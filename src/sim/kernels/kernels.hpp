#pragma once
#include "scene/scene.hpp"
#include "sim/core/simulation.hpp"

#include <filesystem>
#include <vector>

namespace simreel::sim {

/// Returns the files of all shaders of a scene's objects, with what they include. Those of a shader that
/// cannot be compiled are the ones it had last.
[[nodiscard]] std::vector<std::filesystem::path> shaderFiles(const scene::Scene& scene);
/// Compute shaders that a user wrote: Unity's .compute, HLSL or GLSL.
[[nodiscard]] SimulationKind kernelsKind();
/// Functions `check` and `make` for all kinds whose parameters are KernelsParameters.
void checkKernels(const scene::Object& object, const Setting& setting);
[[nodiscard]] std::unique_ptr<Simulation> makeKernels(const scene::Object& object, const Setting& setting);

}  // namespace simreel::sim
