#pragma once
#include <array>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Marching cubes' table, made from a rule for faces alone, so that cubes agree about what they share: on a
/// face with two inside corners across, those are joined and each outside one is cut off. Corner
/// x + 2 y + 4 z of a cube is bit x + 2 y + 4 z of its kind. Edges: 0 to 3 along x, at (y, z) of (0, 0),
/// (1, 0), (0, 1), (1, 1); 4 to 7 along y at such (x, z); 8 to 11 along z at (x, y).
struct CubeKind {
  std::vector<std::array<int, 3>> triangles;  ///< edges, against the clock seen from outside
};
[[nodiscard]] const std::array<CubeKind, 256>& cubeKinds();

/// For kernels: x triangles, y and z their edges in four bits each.
[[nodiscard]] std::vector<glm::uvec4> cubeWords();

}  // namespace simreel::sim
