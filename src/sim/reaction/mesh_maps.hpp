#pragma once
#include "sim/mesh_cells/cells.hpp"
#include "sim/reaction/parameters.hpp"

#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Where the cells of a mesh lie on pictures and on other objects' fields: from the left and from the top,
/// in mapParts (glsl/reaction/sampling.glsl) of their width and height. A cell on a seam of texture
/// coordinates has those of the vertex that a face comes to first. Throws UserError(usage) where `mesh`
/// asks for coordinates that it does not have; `whose`: "reaction \"x\"".
[[nodiscard]] std::vector<glm::ivec2> mapPlaces(const ReactionMesh& parameters, const Mesh& mesh,
                                                const MeshCells& cells, const std::string& whose);

}  // namespace simreel::sim
