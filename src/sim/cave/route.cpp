#include "sim/cave/route.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>

namespace simreel::sim {

namespace {

unsigned distanceAt(const CaveGrid& grid, const std::vector<unsigned>& distances, glm::ivec2 at) {
  if (at.x < 0 || at.y < 0 || at.x >= grid.size.x || at.y >= grid.size.y) return noCell;
  return distances[static_cast<std::size_t>(at.y) * 32 * static_cast<std::size_t>(grid.rowWords()) +
                   static_cast<std::size_t>(at.x)];
}

/// Returns true if all cells are open whose centres are less than one cell away from `at` along each axis.
bool isClear(const CaveGrid& grid, const std::vector<unsigned>& distances, glm::dvec2 at) {
  const glm::ivec2 low(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)));
  const glm::ivec2 high(static_cast<int>(std::ceil(at.x)), static_cast<int>(std::ceil(at.y)));
  for (int y = low.y; y <= high.y; ++y)
    for (int x = low.x; x <= high.x; ++x)
      if (distanceAt(grid, distances, {x, y}) == noCell) return false;
  return true;
}

/// Returns the mean position of the open cells within a small window around a point. A path that is moved
/// towards this position stays away from walls.
glm::dvec2 openMiddle(const CaveGrid& grid, const std::vector<unsigned>& distances, glm::dvec2 at) {
  constexpr int reach = 3;
  const glm::ivec2 cell(static_cast<int>(std::floor(at.x + 0.5)), static_cast<int>(std::floor(at.y + 0.5)));
  glm::ivec2 sum(0);
  int count = 0;
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x)
      if (distanceAt(grid, distances, cell + glm::ivec2(x, y)) != noCell) {
        sum += glm::ivec2(x, y);
        ++count;
      }
  return glm::dvec2(cell) + (count > 0 ? glm::dvec2(sum) / static_cast<double>(count) : glm::dvec2(0));
}

}  // namespace

std::vector<glm::ivec2> cavePath(const CaveGrid& grid, const std::vector<unsigned>& distances,
                                 unsigned end) {
  constexpr glm::ivec2 ways[] = {
      {0, -1},
      {-1, 0},
      {1, 0},
      {0, 1}};  // Offsets to the four neighbours, ordered by the neighbour's cell index.
  std::vector<glm::ivec2> path = {grid.placeOf(end)};
  for (unsigned left = distanceAt(grid, distances, path.back()); left > 0; --left) {
    const glm::ivec2 here = path.back();
    const auto* nearer = std::find_if(std::begin(ways), std::end(ways), [&](glm::ivec2 way) {
      return distanceAt(grid, distances, here + way) == left - 1;
    });
    SIMREEL_CHECK(nearer != std::end(ways));
    path.push_back(here + *nearer);
  }
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<glm::dvec2> smoothPath(const CaveGrid& grid, const std::vector<unsigned>& distances,
                                   const std::vector<glm::ivec2>& path, int rounds) {
  std::vector<glm::dvec2> points(path.begin(), path.end());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const glm::dvec2 middle = 0.5 * (points[i - 1] + points[i + 1]);
      const glm::dvec2 open = openMiddle(grid, distances, points[i]);
      const glm::dvec2 moved = points[i] + 0.5 * (middle - points[i]) + 0.1 * (open - points[i]);
      if (isClear(grid, distances, moved)) points[i] = moved;
    }
  return points;
}

}  // namespace simreel::sim
