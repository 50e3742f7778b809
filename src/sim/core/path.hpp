#pragma once
#include "scene/value/path_place.hpp"
#include "sim/core/drawable.hpp"

#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Length of a path, m.
[[nodiscard]] double lengthOf(const std::vector<glm::vec3>& path);
/// So far along a path (m); straight on beyond its end.
[[nodiscard]] glm::vec3 pointOn(const std::vector<glm::vec3>& path, double along);

/// Where something stands by a path, and where the way goes there.
struct Standing {
  glm::vec3 position{0};
  glm::vec3 ahead{0, 0, -1};  ///< level, of length 1
};
/// At that time (s). The way's direction is that from half a metre before to half a metre behind, so that
/// it turns steadily; to its right is cross(ahead, y).
[[nodiscard]] Standing standingBy(const std::vector<glm::vec3>& path, const scene::PathPlace& place,
                                  double seconds);

/// Where a camera is that goes along a path, and what it looks at.
struct Stand {
  glm::vec3 eye{0}, target{0};
};
/// At that time (s), undamped. What it looks at is the mean of the way ahead, so it turns before
/// a corner; beyond the end the path goes straight on.
[[nodiscard]] Stand standOn(const std::vector<glm::vec3>& path, const scene::Follow& follow,
                            double seconds);

/// The path of the object of that name, or null.
[[nodiscard]] const Path* pathOf(const Drawables& drawables, const std::string& object);

}  // namespace simreel::sim
