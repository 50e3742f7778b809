#include "sim/polygons/cut.hpp"

#include "sim/polygons/problem.hpp"

#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace simreel::sim {

namespace {

constexpr std::uint64_t maxTests = 400'000'000;

double doubleArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Polygon projected to 2D, counter-clockwise. The corners that have not been cut off form a linked ring.
class EarRing {
 public:
  EarRing(const glm::dvec3& normal, std::span<const glm::vec3> corners) : left_(corners.size()) {
    // Projects along the largest component of the normal.
    const glm::dvec3 size = glm::abs(normal);
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const double side = normal[axis] < 0 ? -1 : 1;
    for (const glm::vec3& corner : corners)
      flat_.emplace_back(corner[(axis + 1) % 3] * side, corner[(axis + 2) % 3]);
    for (unsigned i = 0; i < corners.size(); ++i) {
      next_.push_back(i + 1 == corners.size() ? 0 : i + 1);
      before_.push_back(i == 0 ? static_cast<unsigned>(corners.size()) - 1 : i - 1);
    }
    for (unsigned i = 0; i < corners.size(); ++i) hollow_.push_back(turnAt(i) <= 0);
    for (unsigned i = 0; i < corners.size(); ++i)
      if (hollow_[i]) hollows_.push_back(i);
  }

  [[nodiscard]] std::size_t left() const { return left_; }
  [[nodiscard]] unsigned next(unsigned i) const { return next_[i]; }
  [[nodiscard]] unsigned before(unsigned i) const { return before_[i]; }
  [[nodiscard]] bool convex() const { return hollows_.empty(); }

  /// Returns true if the triangle at a corner contains no other corner, so that it can be cut off (ear).
  /// Adds the number of tested corners to `tests`.
  bool isEar(unsigned i, std::uint64_t& tests) {
    if (hollow_[i]) return false;
    const unsigned a = before_[i], c = next_[i];
    std::size_t kept = 0;
    bool ear = true;
    for (std::size_t k = 0; k < hollows_.size(); ++k) {
      const unsigned other = hollows_[k];
      if (!hollow_[other]) continue;  // Skips corners that are already cut off or no longer concave.
      hollows_[kept++] = other;
      ++tests;
      if (other == a || other == c || !ear) continue;
      ear = !inside(flat_[other], flat_[a], flat_[i], flat_[c]);
    }
    hollows_.resize(kept);
    return ear;
  }

  void cutOff(unsigned i) {
    const unsigned a = before_[i], c = next_[i];
    next_[a] = c;
    before_[c] = a;
    hollow_[i] = false;
    --left_;
    for (const unsigned end : {a, c})
      if (hollow_[end]) hollow_[end] = turnAt(end) <= 0;
  }

 private:
  [[nodiscard]] double turnAt(unsigned i) const {
    return doubleArea(flat_[before_[i]], flat_[i], flat_[next_[i]]);
  }
  /// Returns true if p is inside the triangle or on its edges but not at a corner. Polygons with holes
  /// touch themselves at corners.
  static bool inside(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
    if (p == a || p == b || p == c) return false;
    return doubleArea(a, b, p) >= 0 && doubleArea(b, c, p) >= 0 && doubleArea(c, a, p) >= 0;
  }

  std::size_t left_;
  std::vector<glm::dvec2> flat_;
  std::vector<unsigned> next_, before_;
  std::vector<char> hollow_;       ///< true if the corner is concave or straight
  std::vector<unsigned> hollows_;  ///< indices of concave corners; may include corners that are no longer
                                   ///< concave
};

}  // namespace

glm::dvec3 polygonNormal(std::span<const glm::vec3> corners) {
  glm::dvec3 sum(0);
  if (corners.empty()) return sum;
  // The positions are relative to a corner, because products of large coordinates would cancel, so that the
  // normal of a small polygon far from 0 would lose precision.
  const glm::dvec3 origin(corners[0]);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    sum += glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[i + 1]) - origin);
  return sum;
}

void PolygonCutter::cut(std::span<const glm::vec3> corners,
                        std::vector<std::array<unsigned, 3>>& triangles) {
  if (corners.size() < 3) return;
  if (corners.size() == 3)
    triangles.push_back({0, 1, 2});
  else if (corners.size() == 4)
    cutFour(corners, triangles);
  else
    cutEars(polygonNormal(corners), corners, triangles);
}

/// Splits a quad at its concave corner, or at the first corner if it is convex.
void PolygonCutter::cutFour(std::span<const glm::vec3> corners,
                            std::vector<std::array<unsigned, 3>>& triangles) const {
  const glm::dvec3 normal = polygonNormal(corners);
  unsigned from = 0;
  for (unsigned i = 0; i < 4; ++i) {
    const glm::dvec3 here(corners[i]);
    const glm::dvec3 in = here - glm::dvec3(corners[(i + 3) % 4]);
    const glm::dvec3 out = glm::dvec3(corners[(i + 1) % 4]) - here;
    if (glm::dot(glm::cross(in, out), normal) < 0) from = i;
  }
  const auto corner = [&](unsigned i) { return (from + i) % 4; };
  triangles.push_back({corner(0), corner(1), corner(2)});
  triangles.push_back({corner(0), corner(2), corner(3)});
}

void PolygonCutter::cutEars(const glm::dvec3& normal, std::span<const glm::vec3> corners,
                            std::vector<std::array<unsigned, 3>>& triangles) {
  EarRing ring(normal, corners);
  if (ring.convex()) {
    for (unsigned i = 1; i + 1 < corners.size(); ++i) triangles.push_back({0, i, i + 1});
    return;
  }
  unsigned at = 0;
  std::size_t passed = 0;  // number of corners visited since the last one that was cut off
  while (ring.left() > 3) {
    const bool stuck = passed > ring.left();  // The polygon intersects itself or has no area.
    if (stuck || ring.isEar(at, tests_)) {
      triangles.push_back({ring.before(at), at, ring.next(at)});
      ring.cutOff(at);
      passed = 0;
      at = ring.next(ring.next(at));  // skips a corner, because cutting off adjacent corners would give
                                      // thin fans
      continue;
    }
    if (++tests_ > maxTests)
      throw PolygonProblem("has hollow faces of too many corners to be cut into triangles; cut them up");
    at = ring.next(at);
    ++passed;
  }
  triangles.push_back({ring.before(at), at, ring.next(at)});
}

}  // namespace simreel::sim
