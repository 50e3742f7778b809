#pragma once
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"

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
  glm::vec2 reach{1, 1};        ///< lengths of the two
};

/// `size` in pixels gives the aspect ratio. +y is up; a positive roll turns the camera clockwise, so the
/// picture turns counter-clockwise.
[[nodiscard]] View viewAt(const scene::Camera& camera, double seconds, glm::ivec2 size,
                          const sim::Drawables& drawables);

/// Where a camera is that goes along a path, and what it looks at.
struct Stand {
  glm::vec3 eye{0}, target{0};
};
/// Of one that goes round its target, at that time (s).
[[nodiscard]] Stand standAround(const glm::vec3& target, const scene::Orbit& orbit, double seconds);
/// At that time (s). What it looks at is the mean of the way ahead, so it turns before
/// a corner; beyond the end the path goes straight on.
[[nodiscard]] Stand standOn(const std::vector<glm::vec3>& path, const scene::Follow& follow,
                            double seconds);

}  // namespace simreel::draw
