#include "sim/water/skirt.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

Mesh groundSides(const WaterPlan& plan, int walls, float rim) {
  const shader::WaterLook look = plan.look();
  const glm::ivec2 size = plan.parameters().size;
  const std::vector<glm::vec4>& cells = plan.firstCells();
  float lowest = cells.front().w;
  for (const glm::vec4& cell : cells) lowest = std::min(lowest, cell.w);
  lowest -= 0.5F * look.cell;  // The sides end within a ground on which the lowest bed lies.
  const float width = static_cast<float>(size.x - 1) * look.cell;
  // First vertex and direction of each side, so that the outside is at the right: west, east, north, south.
  struct Side {
    glm::ivec2 first, way;
    glm::vec3 normal;
  };
  const std::array<Side, 4> sides = {{{{0, 0}, {0, 1}, {-1, 0, 0}},
                                      {{size.x - 1, size.y - 1}, {0, -1}, {1, 0, 0}},
                                      {{size.x - 1, 0}, {-1, 0}, {0, 0, -1}},
                                      {{0, size.y - 1}, {1, 0}, {0, 0, 1}}}};
  Mesh mesh;
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const Side& side = sides[s];
    const int count = side.way.x != 0 ? size.x : size.y;
    const auto begin = static_cast<unsigned>(mesh.positions.size());
    for (int i = 0; i < count; ++i) {
      const glm::ivec2 at = side.first + i * side.way;
      // A corner belongs to two sides.
      const int touched = (at.x == 0 ? 1 : 0) | (at.x == size.x - 1 ? 2 : 0) | (at.y == 0 ? 4 : 0) |
                          (at.y == size.y - 1 ? 8 : 0);
      float top = cells[static_cast<std::size_t>(at.y) * size.x + at.x].w;
      if ((walls & touched) != 0) top = std::max(top, rim);
      for (const float height : {top, lowest}) {
        mesh.positions.emplace_back(look.left + static_cast<float>(at.x) * look.cell, look.base + height,
                                    look.back + static_cast<float>(at.y) * look.cell);
        mesh.normals.push_back(side.normal);
        mesh.uvs.emplace_back(static_cast<float>(i) * look.cell / width, (top - height) / width);
      }
    }
    for (unsigned i = 0; i + 1 < static_cast<unsigned>(count); ++i) {
      const unsigned a = begin + 2 * i;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, a + 3, a, a + 3, a + 2});
    }
  }
  return mesh;
}

}  // namespace simreel::sim
