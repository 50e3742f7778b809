#pragma once
#include "sim/mesh_cells/cells.hpp"
#include "sim/reaction/parameters.hpp"

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Returns each mesh cell's position on pictures and on other objects' fields: distances from the left and
/// from the top, in units of 1/mapParts (glsl/reaction/sampling.glsl) of the width and height. A cell on a
/// texture seam uses the coordinates of the first vertex in face order. Throws UserError(usage) if the
/// scene requires texture coordinates and `mesh` has none. `whose`: name for messages, such as "reaction
/// \"x\"".
[[nodiscard]] std::vector<glm::ivec2> mapPlaces(const ReactionMesh& parameters, const Mesh& mesh,
                                                const MeshCells& cells, const std::string& whose);

}  // namespace simreel::sim
