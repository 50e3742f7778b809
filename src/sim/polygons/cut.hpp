#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Maximum number of corners of a face.
inline constexpr std::size_t maxCorners = 10'000;

/// Returns the polygon's normal, whose length is twice the polygon's area: the sum of cross products of its
/// edges (Newell).
[[nodiscard]] glm::dvec3 polygonNormal(std::span<const glm::vec3> corners);

/// Triangulates polygons, including concave ones. A polygon with n corners gives n - 2 triangles of the
/// same orientation, which fill its inside. A self-intersecting polygon gets an arbitrary triangulation.
class PolygonCutter {
 public:
  /// Appends the triangles as corner indices. Throws PolygonProblem if concave polygons with many corners,
  /// for which the time grows quadratically, would take seconds in total.
  void cut(std::span<const glm::vec3> corners, std::vector<std::array<unsigned, 3>>& triangles);

 private:
  void cutFour(std::span<const glm::vec3> corners, std::vector<std::array<unsigned, 3>>& triangles) const;
  void cutEars(const glm::dvec3& normal, std::span<const glm::vec3> corners,
               std::vector<std::array<unsigned, 3>>& triangles);

  std::uint64_t tests_ = 0;
};

}  // namespace simreel::sim
