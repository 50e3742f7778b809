#pragma once
#include <array>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Triangle table of marching cubes. It is generated from one rule for faces, so that neighbouring cubes
/// agree on their common face: if two inside corners of a face are diagonally opposite, they are connected
/// and each outside corner is cut off. Bit x + 2 y + 4 z of a cube's kind tells whether corner (x, y, z) is
/// inside. Edges 0 to 3 are along x, at (y, z) = (0, 0), (1, 0), (0, 1), (1, 1); edges 4 to 7 are along y
/// at (x, z) in the same order, and edges 8 to 11 along z at (x, y).
struct CubeKind {
  std::vector<std::array<int, 3>> triangles;  ///< triangles as edge indices, counter-clockwise as seen from
                                              ///< outside
};
[[nodiscard]] const std::array<CubeKind, 256>& cubeKinds();

/// Returns the table for kernels: x is the number of triangles; y and z hold the triangles' edges in four
/// bits each.
[[nodiscard]] std::vector<glm::uvec4> cubeWords();

}  // namespace simreel::sim
