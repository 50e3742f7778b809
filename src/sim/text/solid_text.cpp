#include "sim/text/solid_text.hpp"

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

/// Edge of an outline that is not horizontal, from its lower to its upper end.
struct Side {
  glm::dvec2 from, to;
  int turn;  ///< winding: 1 if the outline goes up along the edge, otherwise -1

  [[nodiscard]] double at(double y) const {
    if (y == from.y) return from.x;
    if (y == to.y) return to.x;
    return from.x + (to.x - from.x) * ((y - from.y) / (to.y - from.y));
  }
};

std::vector<Side> sidesOf(const TextOutlines& outlines) {
  std::vector<Side> sides;
  for (const auto& polygon : outlines)
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      if (a.y < b.y) sides.push_back({a, b, 1});
      if (b.y < a.y) sides.push_back({b, a, -1});
    }
  return sides;
}

/// Returns the heights at which edges begin, end or cross.
std::vector<double> heightsOf(const std::vector<Side>& sides) {
  std::set<double> heights;
  for (const Side& side : sides) {
    heights.insert(side.from.y);
    heights.insert(side.to.y);
  }
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t k = i + 1; k < sides.size(); ++k) {
      const Side &a = sides[i], &b = sides[k];
      const double low = std::max(a.from.y, b.from.y), high = std::min(a.to.y, b.to.y);
      if (!(low < high)) continue;
      const double below = a.at(low) - b.at(low), above = a.at(high) - b.at(high);
      if (below * above < 0) heights.insert(low + (high - low) * (below / (below - above)));
    }
  return {heights.begin(), heights.end()};
}

}  // namespace

std::vector<Trapezoid> trapezoids(const TextOutlines& outlines) {
  const std::vector<Side> sides = sidesOf(outlines);
  const std::vector<double> heights = heightsOf(sides);
  std::vector<Trapezoid> found;
  // Trapezoids that may continue upwards. The key holds their left and right edges.
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> open;
  for (std::size_t h = 0; h + 1 < heights.size(); ++h) {
    const double low = heights[h], high = heights[h + 1], middle = 0.5 * (low + high);
    std::vector<std::pair<double, std::size_t>> crossed;
    for (std::size_t i = 0; i < sides.size(); ++i)
      if (sides[i].from.y <= low && sides[i].to.y >= high) crossed.emplace_back(sides[i].at(middle), i);
    std::sort(crossed.begin(), crossed.end());
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> next;
    int turns = 0;
    std::size_t left = 0;
    for (const auto& [x, i] : crossed) {
      const int before = turns;
      turns += sides[i].turn;
      if (before == 0) left = i;
      if (before == 0 || turns != 0) continue;
      const auto below = open.find({left, i});
      if (below == open.end()) {
        next[{left, i}] = found.size();
        found.push_back(
            {low, high, sides[left].at(low), sides[i].at(low), sides[left].at(high), sides[i].at(high)});
      } else {
        Trapezoid& same = found[below->second];
        same.top = high;
        same.topLeft = sides[left].at(high);
        same.topRight = sides[i].at(high);
        next[{left, i}] = below->second;
      }
    }
    open = std::move(next);
  }
  return found;
}

namespace {

/// Assembles the mesh; positions in metres.
class TextSolid {
 public:
  TextSolid(const TextOutlines& outlines, double height, double depth) : height_(height), depth_(depth) {
    low_ = high_ = outlines.front().front();
    for (const auto& polygon : outlines)
      for (const glm::dvec2& point : polygon) {
        low_ = glm::min(low_, point);
        high_ = glm::max(high_, point);
      }
    parts_ = trapezoids(outlines);
    for (const Trapezoid& part : parts_) {
      corners_[part.bottom].insert({part.bottomLeft, part.bottomRight});
      corners_[part.top].insert({part.topLeft, part.topRight});
    }
    face(0.5 * depth, 1);
    if (depth > 0) {
      face(-0.5 * depth, -1);
      walls(outlines);
    }
  }
  Mesh release() { return std::move(mesh_); }

 private:
  unsigned vertex(glm::dvec2 at, double z, glm::dvec3 normal) {
    const glm::dvec2 size = glm::max(high_ - low_, glm::dvec2(1e-9));
    mesh_.positions.emplace_back(height_ * at.x, height_ * at.y, z);
    mesh_.normals.emplace_back(normal);
    mesh_.uvs.emplace_back((at.x - low_.x) / size.x, (high_.y - at.y) / size.y);
    return static_cast<unsigned>(mesh_.positions.size() - 1);
  }
  void triangle(unsigned a, unsigned b, unsigned c) {
    for (const unsigned corner : {a, b, c}) mesh_.indices.push_back(corner);
  }

  /// Returns the x coordinates, at a height, of all points from one corner to the other, including both.
  [[nodiscard]] std::vector<double> along(double y, double left, double right) const {
    const std::set<double>& all = corners_.at(y);
    return {all.lower_bound(left), all.upper_bound(right)};
  }

  /// Adds the front (if `side` is 1) or the back (if it is -1). Each piece is a fan around its centre, so
  /// that neighbours have whole edges in common.
  void face(double z, double side) {
    std::map<std::pair<double, double>, unsigned> known;
    const auto corner = [&](double x, double y) {
      const auto [place, fresh] = known.try_emplace({x, y}, 0U);
      if (fresh) place->second = vertex({x, y}, z, {0, 0, side});
      return place->second;
    };
    for (const Trapezoid& part : parts_) {
      std::vector<unsigned> around;
      for (const double x : along(part.bottom, part.bottomLeft, part.bottomRight))
        around.push_back(corner(x, part.bottom));
      auto above = along(part.top, part.topLeft, part.topRight);
      std::reverse(above.begin(), above.end());
      for (const double x : above) around.push_back(corner(x, part.top));
      around.erase(std::unique(around.begin(), around.end()), around.end());
      if (around.size() < 3) continue;
      const auto put = [&](unsigned a, unsigned b, unsigned c) {
        if (side > 0)
          triangle(a, b, c);
        else
          triangle(a, c, b);
      };
      if (around.size() == 3) {
        put(around[0], around[1], around[2]);
        continue;
      }
      const glm::dvec2 middle(0.25 * (part.bottomLeft + part.bottomRight + part.topLeft + part.topRight),
                              0.5 * (part.bottom + part.top));
      const unsigned hub = vertex(middle, z, {0, 0, side});
      for (std::size_t i = 0; i < around.size(); ++i) put(hub, around[i], around[(i + 1) % around.size()]);
    }
  }

  /// Returns the corners of pieces that are on an edge of an outline, in the direction of the edge.
  [[nodiscard]] std::vector<glm::dvec2> cuts(glm::dvec2 a, glm::dvec2 b) const {
    std::vector<glm::dvec2> points = {a};
    if (a.y == b.y) {
      const auto level = corners_.find(a.y);
      if (level != corners_.end())
        for (const double x : level->second)
          if (x > std::min(a.x, b.x) && x < std::max(a.x, b.x)) points.emplace_back(x, a.y);
    } else {
      const Side side = a.y < b.y ? Side{a, b, 1} : Side{b, a, -1};
      for (auto level = corners_.upper_bound(side.from.y);
           level != corners_.end() && level->first < side.to.y; ++level)
        if (level->second.contains(side.at(level->first)))
          points.emplace_back(side.at(level->first), level->first);
    }
    points.push_back(b);
    const glm::dvec2 way = b - a;
    std::stable_sort(points.begin(), points.end(), [&](const glm::dvec2& p, const glm::dvec2& q) {
      return glm::dot(p - a, way) < glm::dot(q - a, way);
    });
    return points;
  }

  /// Adds the walls between front and back along the outlines. Normals are smooth where an outline turns by
  /// less than 40 degrees.
  void walls(const TextOutlines& outlines) {
    double area = 0;  // signed area; it is positive if outer outlines are counter-clockwise
    for (const auto& polygon : outlines)
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
        area += a.x * b.y - a.y * b.x;
      }
    const double outwards = area > 0 ? 1 : -1;
    for (const auto& polygon : outlines) {
      const std::size_t count = polygon.size();
      std::vector<glm::dvec2> normals;
      for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec2 way = glm::normalize(polygon[(i + 1) % count] - polygon[i]);
        normals.push_back(outwards * glm::dvec2(way.y, -way.x));
      }
      const auto between = [&](std::size_t side, std::size_t other) {
        constexpr double round = 0.766;  // cosine of 40 degrees
        if (glm::dot(normals[side], normals[other]) < round) return normals[side];
        return glm::normalize(normals[side] + normals[other]);
      };
      for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % count];
        wall(cuts(a, b), between(i, (i + count - 1) % count), between(i, (i + 1) % count), outwards);
      }
    }
  }
  void wall(const std::vector<glm::dvec2>& points, glm::dvec2 first, glm::dvec2 last, double outwards) {
    const double length = glm::length(points.back() - points.front());
    std::vector<std::pair<unsigned, unsigned>> posts;  // pairs of front and back vertices
    for (const glm::dvec2& point : points) {
      const double share = glm::length(point - points.front()) / length;
      const glm::dvec3 normal(glm::normalize(first + share * (last - first)), 0);
      posts.emplace_back(vertex(point, 0.5 * depth_, normal), vertex(point, -0.5 * depth_, normal));
    }
    for (std::size_t i = 0; i + 1 < posts.size(); ++i) {
      auto [frontA, backA] = posts[i];
      auto [frontB, backB] = posts[i + 1];
      if (outwards < 0) {
        std::swap(frontA, frontB);
        std::swap(backA, backB);
      }
      triangle(backA, backB, frontB);
      triangle(backA, frontB, frontA);
    }
  }

  double height_, depth_;
  glm::dvec2 low_{0}, high_{0};
  std::vector<Trapezoid> parts_;
  std::map<double, std::set<double>> corners_;  ///< x coordinates of all pieces' corners by height
  Mesh mesh_;
};

}  // namespace

Mesh solidText(const TextOutlines& outlines, double height, double depth) {
  if (outlines.empty()) return {};
  return TextSolid(outlines, height, depth).release();
}

}  // namespace simreel::sim
