#pragma once
#include "sim/core/simulation.hpp"

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Returns the triangle indices of a particle grid (x fastest): two triangles per quad, three indices per
/// triangle. The front face is the side to which the cross product of the step to the next row and the step
/// to the right points.
[[nodiscard]] std::vector<unsigned> gridIndices(glm::ivec2 size);

/// Returns the sheet as a mesh for export. The normal at a particle is the cross product of the central
/// differences of its neighbours, one-sided at borders; uv = (x / (W - 1), y / (H - 1)) for W x H
/// particles. positions.size() must equal size.x * size.y.
[[nodiscard]] MeshTable sheetMesh(glm::ivec2 size, std::span<const glm::vec4> positions);

}  // namespace simreel::sim
