#include "sim/isolines/lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

constexpr double samplePixels = 2;  // distance in pixels between samples of a magnified field
constexpr int maxPerCell = 16;
constexpr double minLabelDistance = 0.4;  // minimum distance in pixels between points of a line
constexpr double minLoopLength = 6;  // minimum length in pixels of closed lines; shorter closed lines are
                                     // omitted

/// Values of a field, extrapolated linearly beyond its edges.
struct Cells {
  std::span<const float> values;
  glm::ivec2 size;

  [[nodiscard]] double at(int x, int y) const {
    const int inX = std::clamp(x, 0, size.x - 1), inY = std::clamp(y, 0, size.y - 1);
    double value = inside(inX, inY);
    if (x != inX) value += std::abs(x - inX) * (value - inside(inwards(inX, size.x), inY));
    if (y != inY) value += std::abs(y - inY) * (inside(inX, inY) - inside(inX, inwards(inY, size.y)));
    return value;
  }

 private:
  /// Returns the index of the inner neighbour of a cell at an edge.
  static int inwards(int edge, int count) { return edge == 0 ? std::min(1, count - 1) : edge - 1; }
  [[nodiscard]] double inside(int x, int y) const {
    const auto value =
        static_cast<double>(values[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                                   static_cast<std::size_t>(x)]);
    return std::isfinite(value) ? value : std::numeric_limits<double>::quiet_NaN();
  }
};

std::array<double, 4> splineWeights(double t) {
  const double t2 = t * t, t3 = t2 * t;
  return {0.5 * (-t3 + 2 * t2 - t), 0.5 * (3 * t3 - 5 * t2 + 2), 0.5 * (-3 * t3 + 4 * t2 + t),
          0.5 * (t3 - t2)};
}

/// Returns the value at a position in cells, where the centre of cell (0, 0) is at (0.5, 0.5).
double splineAt(const Cells& cells, glm::dvec2 place) {
  const glm::dvec2 from = glm::floor(place - 0.5);
  const glm::dvec2 beyond = place - 0.5 - from;
  const auto across = splineWeights(beyond.x), down = splineWeights(beyond.y);
  const glm::ivec2 first(from);
  double sum = 0;
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 4; ++x) {
      const double weight = across[static_cast<std::size_t>(x)] * down[static_cast<std::size_t>(y)];
      if (weight != 0) sum += weight * cells.at(first.x + x - 1, first.y + y - 1);
    }
  return sum;
}

/// Returns the mean of a block of cells around a corner between cells.
double meanAround(const Cells& cells, glm::ivec2 corner, glm::ivec2 block) {
  double sum = 0;
  for (int y = 0; y < block.y; ++y)
    for (int x = 0; x < block.x; ++x)
      sum += cells.at(corner.x - block.x / 2 + x, corner.y - block.y / 2 + y);
  return sum / block.x / block.y;
}

/// Finds the lines of one level by marching squares.
class Marching {
 public:
  Marching(const IsoGrid& grid, double level)
      : grid_(grid),
        level_(level),
        links_(2 * static_cast<std::size_t>(grid.size.x) * static_cast<std::size_t>(grid.size.y),
               {-1, -1}) {
    for (int y = 0; y + 1 < grid.size.y; ++y)
      for (int x = 0; x + 1 < grid.size.x; ++x) square(x, y);
  }

  [[nodiscard]] std::vector<IsoLine> lines() {
    std::vector<IsoLine> all;
    for (const int edge : met_)
      if (link(edge)[0] >= 0 && link(edge)[1] < 0) all.push_back(walk(edge));
    for (const int edge : met_)
      if (link(edge)[0] >= 0) all.push_back(walk(edge));
    return all;
  }

 private:
  [[nodiscard]] int pointAt(int x, int y) const { return y * grid_.size.x + x; }
  [[nodiscard]] double value(int point) const { return grid_.values[static_cast<std::size_t>(point)]; }
  /// Returns the two neighbours of an edge on its line; -1 if none exists.
  [[nodiscard]] std::array<int, 2>& link(int edge) { return links_[static_cast<std::size_t>(edge)]; }

  /// Joins those edges of a square that the line crosses. The edge to the right of point p has the number 2
  /// p, the edge below it has the number 2 p + 1.
  void square(int x, int y) {
    const int points[] = {pointAt(x, y), pointAt(x + 1, y), pointAt(x + 1, y + 1), pointAt(x, y + 1)};
    int inside = 0;
    for (int i = 0; i < 4; ++i) {
      if (std::isnan(value(points[i]))) return;
      if (value(points[i]) >= level_) inside |= 1 << i;
    }
    const int edges[] = {2 * points[0], 2 * points[1] + 1, 2 * points[3], 2 * points[0] + 1};
    int crossed[4], count = 0;
    for (int i = 0; i < 4; ++i)
      if ((inside >> i & 1) != (inside >> (i + 1) % 4 & 1)) crossed[count++] = edges[i];
    if (count == 2) join(crossed[0], crossed[1]);
    if (count < 4) return;
    const double middle =
        0.25 * (value(points[0]) + value(points[1]) + value(points[2]) + value(points[3]));
    // The line cuts off the corner that differs from the centre.
    const bool cutsFirst = (middle >= level_) != ((inside & 1) != 0);
    join(edges[0], cutsFirst ? edges[3] : edges[1]);
    join(edges[2], cutsFirst ? edges[1] : edges[3]);
  }

  void join(int a, int b) {
    for (const auto& [edge, other] : {std::pair(a, b), std::pair(b, a)}) {
      if (link(edge)[0] < 0) met_.push_back(edge);
      link(edge)[link(edge)[0] < 0 ? 0 : 1] = other;
    }
  }

  /// Follows a line, starting from an edge, and removes the links on it.
  IsoLine walk(int edge) {
    IsoLine line;
    const int start = edge;
    for (int before = -1;;) {
      line.points.push_back(crossing(edge));
      const std::array<int, 2> both = std::exchange(link(edge), {-1, -1});
      const int next = both[0] != before ? both[0] : both[1];
      if (next < 0 || next == start || link(next)[0] < 0) {
        line.closed = next == start && line.points.size() > 2;
        return line;
      }
      before = edge;
      edge = next;
    }
  }

  [[nodiscard]] glm::dvec2 crossing(int edge) const {
    const int from = edge / 2;
    const int to = edge % 2 == 0 ? from + 1 : from + grid_.size.x;
    const double part = (level_ - value(from)) / (value(to) - value(from));
    const glm::dvec2 at(from % grid_.size.x, from / grid_.size.x);
    return grid_.first +
           grid_.spacing * (at + part * (edge % 2 == 0 ? glm::dvec2(1, 0) : glm::dvec2(0, 1)));
  }

  const IsoGrid& grid_;
  double level_;
  std::vector<std::array<int, 2>> links_;
  std::vector<int> met_;  ///< crossed edges, in the order of the squares
};

double lengthOf(const IsoLine& line) {
  double sum = 0;
  for (std::size_t i = 1; i < line.points.size(); ++i)
    sum += glm::distance(line.points[i - 1], line.points[i]);
  return line.closed ? sum + glm::distance(line.points.back(), line.points.front()) : sum;
}

/// Removes points that are almost at the position of the previous point.
void thin(IsoLine& line) {
  std::vector<glm::dvec2> kept = {line.points.front()};
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const bool isEnd = i + 1 == line.points.size() && !line.closed;
    if (glm::distance(line.points[i], kept.back()) >= minLabelDistance)
      kept.push_back(line.points[i]);
    else if (isEnd && kept.size() > 1)
      kept.back() = line.points[i];
  }
  while (line.closed && kept.size() > 3 && glm::distance(kept.back(), kept.front()) < minLabelDistance)
    kept.pop_back();
  line.points = std::move(kept);
}

/// Appends the pieces of a line that are inside the rectangle.
void clip(IsoLine line, const glm::dvec4& part, std::vector<IsoLine>& clipped) {
  const auto inside = [&](const glm::dvec2& p) {
    return p.x >= part.x && p.y >= part.y && p.x <= part.z && p.y <= part.w;
  };
  if (std::all_of(line.points.begin(), line.points.end(), inside))
    return clipped.push_back(std::move(line));
  if (line.closed) line.points.push_back(line.points.front());
  IsoLine now{{}, false, line.level};
  const auto end = [&] {
    if (now.points.size() > 1) clipped.push_back(now);
    now.points.clear();
  };
  for (std::size_t i = 1; i < line.points.size(); ++i) {
    const glm::dvec2 from = line.points[i - 1], to = line.points[i];
    const glm::dvec2 share = shareWithin(from, to, part);
    if (!(share.x < share.y)) {
      end();
      continue;
    }
    if (share.x > 0) end();
    if (now.points.empty()) now.points.push_back(from + share.x * (to - from));
    now.points.push_back(from + share.y * (to - from));
    if (share.y < 1) end();
  }
  end();
}

}  // namespace

glm::dvec2 shareWithin(glm::dvec2 from, glm::dvec2 to, const glm::dvec4& part) {
  double low = 0, high = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const double way = to[axis] - from[axis];
    double a = part[axis] - from[axis], b = part[axis + 2] - from[axis];
    if (way == 0) {
      if (a > 0 || b < 0) return {1, 0};
      continue;
    }
    a /= way;
    b /= way;
    low = std::max(low, std::min(a, b));
    high = std::min(high, std::max(a, b));
  }
  return {low, high};
}

IsoGrid isoGrid(std::span<const float> values, glm::ivec2 cells, const FieldView& view) {
  const Cells all{values, cells};
  glm::dvec2 spacing(1);  // distance in cells between two samples
  for (int axis = 0; axis < 2; ++axis)
    spacing[axis] = view.perPixel[axis] > 1
                        ? std::ceil(view.perPixel[axis])
                        : 1 / std::clamp(std::ceil(1 / view.perPixel[axis] / samplePixels), 1.0,
                                         static_cast<double>(maxPerCell));
  // The range covers all samples that the view needs. The first sample of the field is at the field's
  // corner.
  const glm::dvec2 from = view.origin + view.perPixel * glm::dvec2(view.part.x, view.part.y);
  const glm::dvec2 to = view.origin + view.perPixel * glm::dvec2(view.part.z, view.part.w);
  const glm::dvec2 maximum = glm::floor(glm::dvec2(cells) / spacing);
  const glm::dvec2 first = glm::clamp(glm::floor(from / spacing), glm::dvec2(0), maximum);
  const glm::dvec2 last = glm::clamp(glm::ceil(to / spacing), glm::dvec2(0), maximum);
  IsoGrid grid;
  grid.size = glm::ivec2(last - first) + 1;
  grid.spacing = spacing / view.perPixel;
  grid.first = (first * spacing - view.origin) / view.perPixel;
  grid.values.reserve(static_cast<std::size_t>(grid.size.x) * static_cast<std::size_t>(grid.size.y));
  const glm::ivec2 block(glm::max(spacing, 1.0));
  for (int y = 0; y < grid.size.y; ++y)
    for (int x = 0; x < grid.size.x; ++x) {
      const glm::dvec2 place = (first + glm::dvec2(x, y)) * spacing;
      grid.values.push_back(block.x > 1 || block.y > 1 ? meanAround(all, glm::ivec2(place), block)
                                                       : splineAt(all, place));
    }
  return grid;
}

std::vector<IsoLine> isoLines(const IsoGrid& grid, std::span<const double> levels, const glm::dvec4& part) {
  std::vector<IsoLine> all;
  for (std::size_t level = 0; level < levels.size(); ++level)
    for (IsoLine& line : Marching(grid, levels[level]).lines()) {
      line.level = static_cast<int>(level);
      thin(line);
      if (line.points.size() < 2 || (line.closed && lengthOf(line) < minLoopLength)) continue;
      clip(std::move(line), part, all);
    }
  return all;
}

std::vector<std::vector<glm::dvec2>> isoStroke(const IsoLine& line, double width) {
  const std::size_t count = line.points.size();
  if (count < 2) return {};
  const auto across = [&](std::size_t from, std::size_t to) {
    const glm::dvec2 way = line.points[to] - line.points[from];
    const double length = glm::length(way);
    return length > 0 ? glm::dvec2(-way.y, way.x) / length : glm::dvec2(0);
  };
  std::vector<glm::dvec2> left, right;
  for (std::size_t i = 0; i < count; ++i) {
    const bool starts = i == 0 && !line.closed, ends = i + 1 == count && !line.closed;
    const glm::dvec2 after = ends ? across(i - 1, i) : across(i, (i + 1) % count);
    const glm::dvec2 before = starts ? after : across((i + count - 1) % count, i);
    const glm::dvec2 sum = before + after;
    const double length = glm::length(sum);
    const glm::dvec2 normal = length > 1e-9 ? sum / length : after;
    // The mitre of a sharp bend is limited to twice the width.
    const glm::dvec2 offset = normal * (0.5 * width / std::max(glm::dot(normal, after), 0.5));
    left.push_back(line.points[i] + offset);
    right.push_back(line.points[i] - offset);
  }
  std::reverse(right.begin(), right.end());
  if (line.closed) return {std::move(left), std::move(right)};
  left.insert(left.end(), right.begin(), right.end());
  return {std::move(left)};
}

}  // namespace simreel::sim
