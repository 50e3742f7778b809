#include "draw/lights/lamp_values.hpp"

#include <bit>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace simreel::draw {

std::vector<std::uint32_t> lampCells(const std::vector<shader::Lamp>& lamps, int ranged) {
  const std::size_t first = lamps.size() - static_cast<std::size_t>(ranged);
  glm::vec3 low(1e30F), high(-1e30F);
  const auto reach = [](const shader::Lamp& lamp) { return 1.0F / std::sqrt(lamp.across.w); };
  for (std::size_t i = first; i < lamps.size(); ++i) {
    low = glm::min(low, glm::vec3(lamps[i].place) - reach(lamps[i]));
    high = glm::max(high, glm::vec3(lamps[i].place) + reach(lamps[i]));
  }
  const glm::ivec3 count(shader::lampCellsAcross, shader::lampCellsUp, shader::lampCellsAcross);
  const glm::vec3 perMetre = glm::vec3(count) / glm::max(high - low, glm::vec3(1e-6F));
  const std::size_t words = (static_cast<std::size_t>(ranged) + 31) / 32;
  std::vector<std::uint32_t> cells(static_cast<std::size_t>(shader::lampCellHead) +
                                   words * shader::lampCellsAcross * shader::lampCellsAcross *
                                       shader::lampCellsUp);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<int>(k);
    cells[k] = std::bit_cast<std::uint32_t>(low[axis]);
    cells[3 + k] = std::bit_cast<std::uint32_t>(perMetre[axis]);
  }
  for (std::size_t i = first; i < lamps.size(); ++i) {
    const glm::vec3 middle(lamps[i].place);
    // Enlarges the range slightly, so that a rounding error cannot omit a cell that the lamp touches.
    const float far = 1.001F * reach(lamps[i]);
    const glm::ivec3 from =
        glm::clamp(glm::ivec3(glm::floor((middle - far - low) * perMetre)) - 1, glm::ivec3(0), count - 1);
    const glm::ivec3 to =
        glm::clamp(glm::ivec3(glm::floor((middle + far - low) * perMetre)) + 1, glm::ivec3(0), count - 1);
    for (int y = from.y; y <= to.y; ++y)
      for (int z = from.z; z <= to.z; ++z)
        for (int x = from.x; x <= to.x; ++x) {
          const glm::vec3 corner = low + glm::vec3(x, y, z) / perMetre;
          const glm::vec3 nearest =
              glm::clamp(middle, corner - 0.001F / perMetre, corner + 1.001F / perMetre);
          if (glm::length(nearest - middle) > far) continue;
          const int number = (y * count.z + z) * count.x + x;
          const auto cell = static_cast<std::size_t>(number);
          cells[static_cast<std::size_t>(shader::lampCellHead) + cell * words + (i - first) / 32] |=
              1U << ((i - first) % 32);
        }
  }
  return cells;
}

}  // namespace simreel::draw
