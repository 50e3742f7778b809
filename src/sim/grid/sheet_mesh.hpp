#pragma once
#include "sim/core/simulation.hpp"

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Two triangles a quad of a grid of particles, x fastest: three indices each. Their front is where the
/// cross product of the way to the next row and the way to the right points.
[[nodiscard]] std::vector<unsigned> gridIndices(glm::ivec2 size);

/// The sheet as other programs read it: the normal of a particle is the cross product of central
/// differences of its neighbours, one-sided at borders; uv = (x / (W - 1), y / (H - 1)). positions.size()
/// == size.x * size.y.
[[nodiscard]] MeshTable sheetMesh(glm::ivec2 size, std::span<const glm::vec4> positions);

}  // namespace simreel::sim
