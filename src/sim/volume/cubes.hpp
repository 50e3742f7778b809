#pragma once
#include <array>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Triangle table of marching cubes, generated from one rule for faces, so that neighbouring cubes agree on
/// their common face: if two inside corners are diagonally opposite, they are connected and each outside
/// corner is cut off. Corner x + 2 y + 4 z of a cube is bit x + 2 y + 4 z of its kind. Edges: 0 to 3 along
/// x, at (y, z) = (0, 0), (1, 0), (0, 1), (1, 1); 4 to 7 along y at (x, z) in the same order; 8 to 11 along
/// z at (x, y).
struct CubeKind {
  std::vector<std::array<int, 3>> triangles;  ///< triangles as edge indices, counter-clockwise as seen from
                                              ///< outside
};
[[nodiscard]] const std::array<CubeKind, 256>& cubeKinds();

/// Returns the table for kernels: x the number of triangles, y and z their edges in four bits each.
[[nodiscard]] std::vector<glm::uvec4> cubeWords();

}  // namespace simreel::sim
