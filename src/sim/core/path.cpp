#include "sim/core/path.hpp"

#include <glm/geometric.hpp>

namespace simreel::sim {

double lengthOf(const std::vector<glm::vec3>& path) {
  double length = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length += static_cast<double>(glm::distance(path[i - 1], path[i]));
  return length;
}

glm::vec3 pointOn(const std::vector<glm::vec3>& path, double along) {
  for (std::size_t i = 1; i < path.size(); ++i) {
    const glm::vec3 step = path[i] - path[i - 1];
    const auto length = static_cast<double>(glm::length(step));
    if (along <= length || i + 1 == path.size())
      return path[i - 1] + step * static_cast<float>(length > 0 ? along / length : 0.0);
    along -= length;
  }
  return path.front();
}

Standing standingBy(const std::vector<glm::vec3>& path, const scene::PathPlace& place, double seconds) {
  constexpr double reach = 0.5;
  const double along = static_cast<double>(place.progress.at(seconds)) * lengthOf(path);
  Standing standing;
  const glm::vec3 way = pointOn(path, along + reach) - pointOn(path, along - reach);
  if (way.x != 0 || way.z != 0) standing.ahead = glm::normalize(glm::vec3(way.x, 0, way.z));
  const glm::vec3 right(-standing.ahead.z, 0, standing.ahead.x);
  standing.position = pointOn(path, along) + place.side * right + glm::vec3(0, place.height, 0);
  return standing;
}

Stand standOn(const std::vector<glm::vec3>& path, const scene::Follow& follow, double seconds) {
  constexpr int looks = 8;
  const Standing standing = standingBy(path, follow, seconds);
  const double along = static_cast<double>(follow.progress.at(seconds)) * lengthOf(path);
  const glm::vec3 aside = standing.position - pointOn(path, along);
  Stand stand{standing.position, aside};
  for (int i = 1; i <= looks; ++i)
    stand.target += pointOn(path, along + static_cast<double>(follow.ahead) * i / looks) / float(looks);
  return stand;
}

const Path* pathOf(const Drawables& drawables, const std::string& object) {
  for (const Path& path : drawables.paths)
    if (*path.name == object) return &path;
  return nullptr;
}

}  // namespace simreel::sim
