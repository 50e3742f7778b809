#pragma once
#include <span>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::scene {

/// Interface of parameters that describe the object's extent more closely than the box of
/// Parameters::framed.
class Outlined {
 public:
  virtual ~Outlined() = default;
  /// Returns points (metres) whose convex hull contains the object at all times. Returns an empty list if
  /// the box must be used.
  [[nodiscard]] virtual std::vector<glm::vec3> outline() const = 0;
};

/// Returns the farthest point in each of 98 directions, moved outwards by `beyond` metres. For points on a
/// sphere, the hull of the result lies at most 5% of the radius inside the sphere. In each direction, the
/// farthest fraction `stray` of the points (rounded down to a whole number) is skipped, so that a few stray
/// points do not move the camera back. The result does not depend on the order of the points. Returns an
/// empty list if there are no points.
[[nodiscard]] std::vector<glm::vec3> outermost(std::span<const glm::vec3> points, double stray = 0,
                                               float beyond = 0);

/// Like outermost() for balls: returns points on their surfaces. xyz: centre, w: radius in metres. Balls
/// that are larger than the fraction 1 - `stray` of all balls are never skipped.
[[nodiscard]] std::vector<glm::vec3> outermostOfBalls(std::span<const glm::vec4> balls, double stray = 0);

}  // namespace simreel::scene
