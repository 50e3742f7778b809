#include "draw/camera.hpp"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace simreel::draw {

View viewAt(const scene::Camera& camera, double seconds, glm::ivec2 size) {
  View view;
  view.eye = camera.position.at(seconds);
  view.target = camera.target.at(seconds);
  const glm::vec3 along = view.target - view.eye;
  view.forward = glm::length(along) > 1e-6F ? glm::normalize(along) : glm::vec3(0, 0, -1);
  // Looking straight up or down, the picture's top is -z.
  const bool steep = std::abs(view.forward.y) > 0.9999F;
  const glm::vec3 right =
      glm::normalize(glm::cross(view.forward, steep ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0)));
  const glm::vec3 up = glm::cross(right, view.forward);
  const float roll = glm::radians(camera.roll.at(seconds));
  const glm::vec3 r = std::cos(roll) * right - std::sin(roll) * up;
  const glm::vec3 u = std::sin(roll) * right + std::cos(roll) * up;

  const float high = std::tan(0.5F * glm::radians(camera.fieldOfView.at(seconds)));
  const float wide = high * static_cast<float>(size.x) / static_cast<float>(size.y);
  view.right = r * wide;
  view.up = u * high;
  const glm::vec3& f = view.forward;
  const glm::vec3& e = view.eye;
  const glm::mat4 toCamera(glm::vec4(r.x, u.x, -f.x, 0), glm::vec4(r.y, u.y, -f.y, 0),
                           glm::vec4(r.z, u.z, -f.z, 0),
                           glm::vec4(-glm::dot(r, e), -glm::dot(u, e), glm::dot(f, e), 1));
  const float n = camera.near;
  const float d = camera.far - camera.near;
  const glm::mat4 project(glm::vec4(1 / wide, 0, 0, 0), glm::vec4(0, 1 / high, 0, 0),
                          glm::vec4(0, 0, -(camera.far + n) / d, -1),
                          glm::vec4(0, 0, -2 * camera.far * n / d, 0));
  view.viewProjection = project * toCamera;
  return view;
}

}  // namespace simreel::draw
