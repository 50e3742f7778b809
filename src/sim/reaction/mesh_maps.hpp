#pragma once
#include "sim/mesh_cells/cells.hpp"
#include "sim/reaction/parameters.hpp"

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Returns the position of each mesh cell in images and in other objects' fields: the distances from the
/// left and from the top, in units of 1/mapParts (glsl/reaction/sampling.glsl) of the width and of the
/// height. A cell on a texture seam uses the coordinates of its first vertex in face order. Throws
/// UserError(usage) if the scene requires texture coordinates and `mesh` has none. `whose` is the name for
/// messages, such as "reaction \"x\"".
[[nodiscard]] std::vector<glm::ivec2> mapPlaces(const ReactionMesh& parameters, const Mesh& mesh,
                                                const MeshCells& cells, const std::string& whose);

}  // namespace simreel::sim
