#pragma once
#include "sim/core/simulation.hpp"

#include <vector>

namespace simreel::sim {

/// Returns the values of MeshParameters::quantities() for a mesh in world space, in the order of
/// quantities(). Sums are computed in the order of vertices and triangles.
[[nodiscard]] std::vector<double> measureMesh(const MeshTable& mesh);

}  // namespace simreel::sim
