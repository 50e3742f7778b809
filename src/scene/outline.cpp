#include "scene/outline.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
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

std::vector<glm::vec3> outermostOfBalls(std::span<const glm::vec4> balls, double stray) {
  std::vector<glm::vec3> found;
  if (balls.empty()) return found;
  const auto skipped =
      std::min(static_cast<std::size_t>(stray * static_cast<double>(balls.size())), balls.size() - 1);
  std::vector<float> radii;
  radii.reserve(balls.size());
  for (const glm::vec4& ball : balls) radii.push_back(ball.w);
  const auto limit = radii.begin() + static_cast<std::ptrdiff_t>(skipped);
  std::nth_element(radii.begin(), limit, radii.end(), std::greater<>());
  // Large balls first, because none of them is skipped. At most `skipped` balls are large.
  std::vector<glm::vec4> sorted(balls.begin(), balls.end());
  const auto small =
      std::partition(sorted.begin(), sorted.end(), [&](const glm::vec4& ball) { return ball.w > *limit; });
  const auto large = static_cast<std::size_t>(small - sorted.begin());
  std::vector<std::pair<float, glm::vec3>> ranks(sorted.size());
  const auto farther = [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : comesFirst(a.second, b.second);
  };
  for (const glm::vec3& way : directions()) {
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const glm::vec3 centre(sorted[i]);
      ranks[i] = {glm::dot(centre, way) + sorted[i].w, centre + sorted[i].w * way};
    }
    const auto first = ranks.begin() + static_cast<std::ptrdiff_t>(large);
    const auto wanted = first + static_cast<std::ptrdiff_t>(std::min(skipped, sorted.size() - large - 1));
    std::nth_element(first, wanted, ranks.end(), farther);
    const auto largest = std::min_element(ranks.begin(), first, farther);
    found.push_back(largest != first && farther(*largest, *wanted) ? largest->second : wanted->second);
  }
  return found;
}

}  // namespace simreel::scene
