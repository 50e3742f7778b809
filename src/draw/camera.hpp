#pragma once
#include "scene/scene.hpp"

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
  glm::vec3 right{1, 0, 0};     ///< from the middle to the right edge at distance 1 along `forward`
  glm::vec3 up{0, 1, 0};        ///< from the middle to the top edge
};

/// `size` in pixels gives the aspect ratio. +y is up; a positive roll turns the camera clockwise, so the
/// picture turns counter-clockwise.
[[nodiscard]] View viewAt(const scene::Camera& camera, double seconds, glm::ivec2 size);

}  // namespace simreel::draw
