#include "sim/grid/sheet_mesh.hpp"

#include "base/error.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace simreel::sim {

std::vector<unsigned> gridIndices(glm::ivec2 size) {
  std::vector<unsigned> indices;
  indices.reserve(static_cast<std::size_t>(size.x - 1) * static_cast<std::size_t>(size.y - 1) * 6);
  for (int y = 0; y + 1 < size.y; ++y)
    for (int x = 0; x + 1 < size.x; ++x) {
      const auto a = static_cast<unsigned>(y * size.x + x);
      const auto below = a + static_cast<unsigned>(size.x);
      indices.insert(indices.end(), {a, below, a + 1, a + 1, below, below + 1});
    }
  return indices;
}

MeshTable sheetMesh(glm::ivec2 size, std::span<const glm::vec4> positions) {
  SIMREEL_CHECK_EQ(positions.size(), static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  const auto at = [&](int x, int y) {
    return glm::vec3(positions[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                               static_cast<std::size_t>(x)]);
  };
  MeshTable mesh;
  mesh.doubleSided = true;
  mesh.indices = gridIndices(size);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      const glm::vec3 right = at(std::min(x + 1, size.x - 1), y) - at(std::max(x - 1, 0), y);
      const glm::vec3 down = at(x, std::min(y + 1, size.y - 1)) - at(x, std::max(y - 1, 0));
      const glm::vec3 across = glm::cross(down, right);
      const float length = glm::length(across);
      mesh.positions.push_back(at(x, y));
      mesh.normals.push_back(length > 0 ? across / length : glm::vec3(0, 1, 0));
      mesh.uvs.emplace_back(static_cast<float>(x) / static_cast<float>(size.x - 1),
                            static_cast<float>(y) / static_cast<float>(size.y - 1));
    }
  return mesh;
}

}  // namespace simreel::sim
