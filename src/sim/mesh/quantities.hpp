#pragma once
#include "sim/core/simulation.hpp"

#include <vector>

namespace simreel::sim {

/// MeshParameters::quantities() of a mesh, in that order, in world space, summed in the order of vertices
/// and triangles.
[[nodiscard]] std::vector<double> measureMesh(const MeshTable& mesh);

}  // namespace simreel::sim
