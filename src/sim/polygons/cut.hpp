#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Maximum number of corners of a face.
inline constexpr std::size_t maxCorners = 10'000;

/// Returns the polygon's normal with twice its area as length: the sum of cross products of its edges
/// (Newell).
[[nodiscard]] glm::dvec3 polygonNormal(std::span<const glm::vec3> corners);

/// Triangulates polygons, concave ones along their inside: n - 2 triangles for n corners, with the
/// polygon's orientation. A self-intersecting polygon gets some arbitrary triangulation.
class PolygonCutter {
 public:
  /// Appends the triangles as corner indices. Throws PolygonProblem if concave polygons with many corners,
  /// whose time grows quadratically, would take seconds in total.
  void cut(std::span<const glm::vec3> corners, std::vector<std::array<unsigned, 3>>& triangles);

 private:
  void cutFour(std::span<const glm::vec3> corners, std::vector<std::array<unsigned, 3>>& triangles) const;
  void cutEars(const glm::dvec3& normal, std::span<const glm::vec3> corners,
               std::vector<std::array<unsigned, 3>>& triangles);

  std::uint64_t tests_ = 0;
};

}  // namespace simreel::sim
