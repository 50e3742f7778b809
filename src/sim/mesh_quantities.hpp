#pragma once
#include "sim/simulation.hpp"

#include <vector>

namespace simreel::sim {

/// What checks may ask of a deformed mesh, in world space, summed in double in the order of vertices and
/// triangles.
[[nodiscard]] std::vector<Quantity> meshQuantities(const MeshTable& mesh);
[[nodiscard]] std::vector<const char*> meshQuantityNames();

}  // namespace simreel::sim
