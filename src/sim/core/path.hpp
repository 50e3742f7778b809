#pragma once
#include "scene/value/path_place.hpp"
#include "sim/core/drawable.hpp"

#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Returns the length of a path in metres.
[[nodiscard]] double lengthOf(const std::vector<glm::vec3>& path);
/// Returns the point at distance `along` (metres) on a path; beyond the end, the path continues straight.
[[nodiscard]] glm::vec3 pointOn(const std::vector<glm::vec3>& path, double along);

/// Position of an object beside a path, and the direction of the path at that position.
struct Standing {
  glm::vec3 position{0};
  glm::vec3 ahead{0, 0, -1};  ///< Direction of the path: a horizontal unit vector.
};
/// Returns the pose of an object beside a path at `seconds`. The direction is the direction between the
/// path points half a metre ahead and half a metre behind, so that it changes smoothly. The vector
/// cross(ahead, y) points to the object's right.
[[nodiscard]] Standing standingBy(const std::vector<glm::vec3>& path, const scene::PathPlace& place,
                                  double seconds);

/// Eye and target of a camera that follows a path.
struct Stand {
  glm::vec3 eye{0}, target{0};
};
/// Returns the undamped camera pose at `seconds`. The target is the mean of the path ahead, so the camera
/// turns before it reaches a corner. Beyond its end, the path continues straight.
[[nodiscard]] Stand standOn(const std::vector<glm::vec3>& path, const scene::Follow& follow,
                            double seconds);

/// Returns the path that the named object publishes, or null if there is none.
[[nodiscard]] const Path* pathOf(const Drawables& drawables, const std::string& object);

}  // namespace simreel::sim
