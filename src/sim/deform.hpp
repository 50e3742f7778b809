#pragma once
#include "sim/mesh_parameters.hpp"
#include "sim/simulation.hpp"

#include <memory>

namespace simreel::sim {

/// A mesh that is displaced anew for each frame (glsl/deform/model.glsl) by the technique of its
/// parameters. Its positions at rest are never written.
[[nodiscard]] std::unique_ptr<Simulation> makeDeformedMesh(const scene::Object& object,
                                                           const MeshParameters& parameters,
                                                           const Mesh& mesh, const Setting& setting);

}  // namespace simreel::sim
