#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Most corners of a face.
inline constexpr std::size_t maxCorners = 10'000;

/// The sum of a polygon's edges crossed (Newell): along its normal, twice its area long.
[[nodiscard]] glm::dvec3 polygonNormal(std::span<const glm::vec3> corners);

/// Cuts polygons into triangles, hollow ones along their insides: n - 2 of n corners, in the polygon's own
/// direction. One that meets itself is cut somehow.
class PolygonCutter {
 public:
  /// Adds the triangles by corner. Throws PolygonProblem where hollow polygons of many corners, whose time
  /// grows with the square, would take seconds in all.
  void cut(std::span<const glm::vec3> corners, std::vector<std::array<unsigned, 3>>& triangles);

 private:
  void cutFour(std::span<const glm::vec3> corners, std::vector<std::array<unsigned, 3>>& triangles) const;
  void cutEars(const glm::dvec3& normal, std::span<const glm::vec3> corners,
               std::vector<std::array<unsigned, 3>>& triangles);

  std::uint64_t tests_ = 0;
};

}  // namespace simreel::sim
