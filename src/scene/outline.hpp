#pragma once
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::scene {

/// Parameters that know better than by a box (Parameters::framed) where their object is.
class Outlined {
 public:
  virtual ~Outlined() = default;
  /// Points (m) of it, wherever it comes, between which all others lie; empty: the box says it all.
  [[nodiscard]] virtual std::vector<glm::vec3> outline() const = 0;
};

/// Of the points those that lie farthest out, one in each of 98 directions, moved by `beyond` (m) that way;
/// their hull lacks 5% of a ball's radius at most. What lies farther than all but the fraction `stray` of
/// them (a whole number of points, rounded down) is left out, so that no camera steps back for a few that
/// went astray. Depends on which points there are, not on their order. Empty for no points.
[[nodiscard]] std::vector<glm::vec3> outermost(std::span<const glm::vec3> points, double stray = 0,
                                               float beyond = 0);

}  // namespace simreel::scene
