#pragma once
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"
#include "sim/core/path.hpp"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::draw {

/// State of the camera at one time.
struct View {
  glm::mat4 viewProjection{1.0F};
  glm::vec3 eye{0};
  glm::vec3 target{0};
  glm::vec3 forward{0, 0, -1};  ///< unit direction of the picture's centre
  /// True for orthographic cameras. All their rays have the direction `forward`.
  bool parallel = false;
  glm::vec3 right{1, 0, 0};  ///< vector from the centre to the right edge of the picture, at distance 1
                             ///< along `forward` (orthographic: at any distance)
  glm::vec3 up{0, 1, 0};     ///< vector from the centre to the top edge of the picture, at the same
                             ///< distance as `right`
  glm::vec2 reach{1, 1};     ///< lengths of `right` and `up`
  /// Distance (m) by which an orthographic eye is moved back from the scene's position, so that no visible
  /// ground lies behind the near plane.
  float farther = 0;
};

/// True if the camera is orthographic.
[[nodiscard]] inline bool isParallel(const scene::Camera& camera) {
  return camera.projection == scene::Projection::orthographic;
}

/// Returns the camera at `seconds`. `size` (pixels) gives the aspect ratio. +y is up. A positive roll turns
/// the camera clockwise, so the picture turns counter-clockwise. `ground`: the visible ground, or null. An
/// orthographic camera that looks down on the ground is moved back until no visible ground lies behind its
/// near plane. Otherwise a strip of the ground would be missing.
[[nodiscard]] View viewAt(const scene::Camera& camera, double seconds, glm::ivec2 size,
                          const sim::Drawables& drawables, const scene::Ground* ground = nullptr);
/// Returns the ground that pictures of the scene show, or null.
[[nodiscard]] inline const scene::Ground* visibleGround(const scene::Scene& scene) {
  return scene.ground && scene.ground->visible ? &*scene.ground : nullptr;
}

/// Position and target of a camera on a path.
using Stand = sim::Stand;
/// Returns the position and target of a camera that orbits `target`, at `seconds`.
[[nodiscard]] Stand orbitPose(const glm::vec3& target, const scene::Orbit& orbit, double seconds);
using sim::standOn;

}  // namespace simreel::draw
