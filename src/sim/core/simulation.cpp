#include "sim/core/simulation.hpp"

#include <algorithm>

namespace simreel::sim {

std::optional<glm::vec3> Simulation::middle(double /*time*/) const {
  glm::dvec3 sum(0);
  std::size_t count = 0;
  if (const auto surface = mesh()) {
    for (const glm::vec3& place : surface->positions) sum += glm::dvec3(place);
    count = surface->positions.size();
  } else {
    const PointTable table = points();
    const std::size_t columns = table.columns.size();
    for (std::size_t i = 0; columns >= 3 && i + columns <= table.values.size(); i += columns) {
      sum += glm::dvec3(table.values[i], table.values[i + 1], table.values[i + 2]);
      ++count;
    }
  }
  if (count == 0) return std::nullopt;
  return glm::vec3(sum / static_cast<double>(count));
}

}  // namespace simreel::sim
