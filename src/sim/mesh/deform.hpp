#pragma once
#include "sim/core/simulation.hpp"
#include "sim/mesh/parameters.hpp"

#include <memory>

namespace simreel::sim {

/// Creates a mesh that is displaced for each frame (glsl/mesh/model.glsl) by the technique that its
/// parameters choose. The rest positions are never modified.
[[nodiscard]] std::unique_ptr<Simulation> makeDeformedMesh(const scene::Object& object,
                                                           const MeshParameters& parameters,
                                                           const Mesh& mesh, const Setting& setting);

}  // namespace simreel::sim
