#pragma once
#include "sim/core/simulation.hpp"
#include "sim/mesh/parameters.hpp"

#include <memory>

namespace simreel::sim {

/// A mesh that is displaced anew for each frame (glsl/mesh/model.glsl) by the technique of its
/// parameters. Its positions at rest are never written.
[[nodiscard]] std::unique_ptr<Simulation> makeDeformedMesh(const scene::Object& object,
                                                           const MeshParameters& parameters,
                                                           const Mesh& mesh, const Setting& setting);

}  // namespace simreel::sim
