#include "sim/contour/wall_plan.hpp"

#include "base/error.hpp"
#include "sim/contour/border.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace simreel::sim {

static_assert(maxSolidLevels == shader::maxWallLevels);

shader::WallGrid wallGrid(const SolidShape& shape, const std::vector<float>& heights,
                          const glm::vec3& position, float grip, const WallContact& contact) {
  SIMREEL_CHECK(heights.size() == shape.levels.size() + 1 && shape.levels.size() <= maxSolidLevels);
  shader::WallGrid grid{};
  grid.corner = solidCorner(shape) + glm::vec2(position.x, position.z);
  grid.spacing = shape.spacing;
  grid.perSpacing = 1.0F / shape.spacing;
  grid.bottom = heights.front() - shape.base + position.y;
  grid.roof = heights.back() + shape.roof + position.y;
  grid.reach = std::max(contact.margin, 1e-3F * shape.spacing);
  grid.kept = shader::exactExp(static_cast<float>(-grip * contact.seconds));
  grid.bounce = contact.bounce;
  grid.levelCount = static_cast<int>(shape.levels.size());
  grid.ceiling = shape.ceiling ? 1 : 0;
  grid.squares = std::max(1, static_cast<int>(std::ceil(grid.reach * grid.perSpacing)));
  SIMREEL_CHECK(grid.squares <= maxWallSquares);
  grid.samples = shape.size + 2;
  for (std::size_t k = 0; k < heights.size(); ++k) grid.heights[k] = heights[k] + position.y;
  for (std::size_t k = 0; k < shape.levels.size(); ++k) grid.levels[k] = shape.levels[k];
  return grid;
}

}  // namespace simreel::sim
