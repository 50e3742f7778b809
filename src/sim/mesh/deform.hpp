#pragma once
#include "sim/core/simulation.hpp"
#include "sim/mesh/parameters.hpp"

#include <memory>

namespace simreel::sim {

/// Creates a mesh that is deformed in each frame (glsl/mesh/model.glsl) with the technique that its
/// parameters choose. The undeformed positions are never modified.
[[nodiscard]] std::unique_ptr<Simulation> makeDeformedMesh(const scene::Object& object,
                                                           const MeshParameters& parameters,
                                                           const Mesh& mesh, const Setting& setting);

}  // namespace simreel::sim
