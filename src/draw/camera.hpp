#pragma once
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"
#include "sim/core/path.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::draw {

/// The camera at one moment.
struct View {
  glm::mat4 viewProjection{1.0F};
  glm::vec3 eye{0};
  glm::vec3 target{0};
  glm::vec3 forward{0, 0, -1};  ///< unit; direction of the middle of the picture
  /// Whether all rays go along `forward`: of an orthographic camera.
  bool parallel = false;
  glm::vec3 right{1, 0, 0};  ///< from the middle to the right edge at distance 1 along `forward`, or at any
  glm::vec3 up{0, 1, 0};     ///< from the middle to the top edge
  glm::vec2 reach{1, 1};     ///< lengths of the two
  /// m that the eye stands farther back than the scene says, for the ground's sake.
  float farther = 0;
};

/// Whether all rays of the camera's pictures go one way.
[[nodiscard]] inline bool isParallel(const scene::Camera& camera) {
  return camera.projection == scene::Projection::orthographic;
}

/// `size` in pixels gives the aspect ratio. +y is up; a positive roll turns the camera clockwise, so the
/// picture turns counter-clockwise.
/// `ground`: what is seen of the ground; null: nothing. An orthographic camera that looks down on it stands
/// as far back as needed to have none of it behind its picture's plane, which would leave a strip of the
/// picture without.
[[nodiscard]] View viewAt(const scene::Camera& camera, double seconds, glm::ivec2 size,
                          const sim::Drawables& drawables, const scene::Ground* ground = nullptr);
/// The ground that a picture of the scene shows.
[[nodiscard]] inline const scene::Ground* groundSeen(const scene::Scene& scene) {
  return scene.ground && scene.ground->visible ? &*scene.ground : nullptr;
}

/// Where a camera is that goes along a path, and what it looks at.
using Stand = sim::Stand;
/// Of one that goes round its target, at that time (s).
[[nodiscard]] Stand standAround(const glm::vec3& target, const scene::Orbit& orbit, double seconds);
using sim::standOn;

}  // namespace simreel::draw
