#include "scene/outline.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include <glm/geometric.hpp>

namespace simreel::scene {

namespace {

/// Returns 98 unit vectors, roughly evenly distributed. They point from the middle of a cube of 5 x 5 x 5
/// cells to the other cells; parallel vectors are included only once.
std::vector<glm::vec3> directions() {
  constexpr int reach = 2;
  std::vector<glm::vec3> ways;
  for (int x = -reach; x <= reach; ++x)
    for (int y = -reach; y <= reach; ++y)
      for (int z = -reach; z <= reach; ++z)
        if (std::gcd(std::gcd(x, y), z) == 1) ways.push_back(glm::normalize(glm::vec3(x, y, z)));
  return ways;
}

bool comesFirst(const glm::vec3& a, const glm::vec3& b) {
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

}  // namespace

std::vector<glm::vec3> outermost(std::span<const glm::vec3> points, double stray, float beyond) {
  std::vector<glm::vec3> found;
  if (points.empty()) return found;
  const auto skipped =
      std::min(static_cast<std::size_t>(stray * static_cast<double>(points.size())), points.size() - 1);
  std::vector<std::pair<float, const glm::vec3*>> ranks(points.size());
  for (const glm::vec3& way : directions()) {
    for (std::size_t i = 0; i < points.size(); ++i) ranks[i] = {glm::dot(points[i], way), &points[i]};
    // Points with equal distances are sorted by their coordinates, so that the result does not depend on
    // the order of the points.
    const auto wanted = ranks.begin() + static_cast<std::ptrdiff_t>(skipped);
    std::nth_element(ranks.begin(), wanted, ranks.end(), [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first > b.first : comesFirst(*a.second, *b.second);
    });
    found.push_back(*wanted->second + beyond * way);
  }
  return found;
}

}  // namespace simreel::scene
