#include "draw/overlay/coverage.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>

namespace simreel::draw {

namespace {

/// Accumulates the areas to the right of polygon edges. Each entry of a row holds the area that an edge in
/// this pixel adds to this pixel and all pixels to the right. A prefix sum of the row therefore gives the
/// coverage.
class Areas {
 public:
  explicit Areas(glm::ivec2 size)
      : size_(size), steps_(static_cast<std::size_t>(size.x + 1) * static_cast<std::size_t>(size.y)) {}

  /// Adds an edge. Coordinates are in pixels from the box corner.
  void add(glm::dvec2 from, glm::dvec2 to) {
    if (from.y == to.y) return;
    const double turn = from.y < to.y ? 1 : -1;
    if (turn < 0) std::swap(from, to);
    const double slope = (to.x - from.x) / (to.y - from.y);
    const auto at = [&](double y) { return y == to.y ? to.x : from.x + slope * (y - from.y); };
    const double first = std::max(from.y, 0.0), last = std::min(to.y, static_cast<double>(size_.y));
    for (double low = first; low < last;) {
      const double high = std::min(std::floor(low) + 1, last);
      addInRow(static_cast<int>(std::floor(low)), {at(low), low}, {at(high), high}, turn);
      low = high;
    }
  }

  [[nodiscard]] std::vector<std::uint8_t> shares() const {
    std::vector<std::uint8_t> shares;
    for (int y = 0; y < size_.y; ++y) {
      double sum = 0;
      for (int x = 0; x < size_.x; ++x) {
        sum += steps_[index(x, y)];
        shares.push_back(static_cast<std::uint8_t>(std::floor(255 * std::min(std::abs(sum), 1.0) + 0.5)));
      }
    }
    return shares;
  }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x + 1) +
           static_cast<std::size_t>(x);
  }

  /// Adds the part of an edge that lies within one row, column by column.
  void addInRow(int row, glm::dvec2 from, glm::dvec2 to, double turn) {
    if (to.x < from.x)
      std::swap(from, to);  // The direction of the edge does not matter for the area, only
                            // its height does.
    const double tall = std::abs(to.y - from.y), wide = to.x - from.x;
    const double right = size_.x;
    for (double x = from.x;;) {
      const double end = std::min(std::floor(x) + 1, to.x);
      const double height = wide > 0 ? tall * ((end - x) / wide) : tall;
      const double middle = std::clamp(0.5 * (x + end), 0.0, right);
      const int column = std::min(static_cast<int>(std::floor(middle)), size_.x - 1);
      const double share = middle - column;
      steps_[index(column, row)] += turn * height * (1 - share);
      steps_[index(column + 1, row)] += turn * height * share;
      if (end >= to.x) break;
      x = end;
    }
  }

  glm::ivec2 size_;
  std::vector<double> steps_;
};

}  // namespace

Coverage coverageOf(std::span<const std::vector<glm::dvec2>> polygons, glm::ivec2 picture) {
  Coverage coverage;
  glm::dvec2 low(1e9), high(-1e9);
  for (const auto& polygon : polygons)
    for (const glm::dvec2& point : polygon) {
      low = glm::min(low, point);
      high = glm::max(high, point);
    }
  const glm::dvec2 whole(picture);
  low = glm::clamp(glm::floor(low), glm::dvec2(0), whole);
  high = glm::clamp(glm::ceil(high), glm::dvec2(0), whole);
  if (!(low.x < high.x) || !(low.y < high.y)) return coverage;
  coverage.corner = glm::ivec2(low);
  coverage.size = glm::ivec2(high) - coverage.corner;
  Areas areas(coverage.size);
  for (const auto& polygon : polygons)
    for (std::size_t i = 0; i < polygon.size(); ++i)
      areas.add(polygon[i] - low, polygon[(i + 1) % polygon.size()] - low);
  coverage.share = areas.shares();
  return coverage;
}

}  // namespace simreel::draw
