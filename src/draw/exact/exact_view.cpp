#include "draw/exact/exact_view.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace simreel::draw {

shader::ExactView exactView(const View& view, const scene::Camera& camera, glm::ivec2 size,
                            const LensPoint& through) {
  // A point p has the depth d = f . (p - e), where e is the eye and f the forward direction. With the unit
  // vector r to the right, p appears at the right edge of the picture if r . (p - e) = d reach.x, so the
  // pixel position times d is linear in p - e. In orthographic views the pixel position itself is linear in
  // p - e. The nearness in orthographic views, 1 - (d - near) / span, must be above 0 for all depths up to
  // twice the far distance.
  const glm::vec2 half = 0.5F * glm::vec2(size);
  const glm::vec3 across = view.right / (view.reach.x * view.reach.x);
  const glm::vec3 up = view.up / (view.reach.y * view.reach.y);
  // If the eye moves by a vector o, points in the focal plane keep their picture positions if -o / focus is
  // added to the ray directions.
  const glm::vec3 turned = through.aside / through.focus;
  const float far = camera.far + view.farther;
  const float right = glm::dot(across, turned), above = glm::dot(up, turned);
  shader::ExactView exact{};
  exact.eye = glm::vec4(view.eye + through.aside, 0);
  exact.across = glm::vec4(half.x * (across + (1 + right) * view.forward), 0);
  exact.down = glm::vec4(half.y * ((1 - above) * view.forward - up), 0);
  exact.forward = glm::vec4(view.forward, 0);
  exact.ray = glm::vec4((view.forward - turned) - view.right + view.up, 0);
  if (view.parallel) {
    const float span = 2 * far;
    exact.across = glm::vec4(half.x * across, 0);
    exact.down = glm::vec4(-half.y * up, 0);
    exact.forward = glm::vec4(view.forward, 1 / span);
    exact.ray = glm::vec4(view.up - view.right, 0);
  }
  exact.rayAcross = glm::vec4(view.right / half.x, 0);
  exact.rayDown = glm::vec4(view.up / -half.y, 0);
  exact.size = size;
  exact.rows = {0, size.y};
  exact.near = camera.near;
  exact.nearOverFar = view.parallel ? 1 - (far - camera.near) / (2 * far) : camera.near / far;
  return exact;
}

namespace {

/// Returns groundNearnessOf() for orthographic views. The ray through a pixel starts o.y above the eye's
/// height and descends by -forward.y per metre. A ground whose height relative to the eye is `down`
/// therefore has the depth (down - o.y) / forward.y.
glm::vec4 nearOfLevel(const shader::ExactView& view, float down) {
  const float steep = view.forward.y, perSpan = view.forward.w;
  if (std::abs(steep) < 1e-6F) return {1e30F, 0, 0, 0};
  const float across = perSpan * view.rayAcross.y / steep, below = perSpan * view.rayDown.y / steep;
  const float corner = 1 + perSpan * (view.near - (down - view.ray.y) / steep);
  const float half = 0.5F * (std::abs(across) + std::abs(below));
  const auto size = glm::vec2(view.size);
  constexpr float slack = 1e-5F;
  const float terms = 1 + std::abs(corner) + std::abs(across) * size.x + std::abs(below) * size.y;
  return {corner + 0.5F * (across + below), across, below, half + slack * terms};
}

}  // namespace

bool isParallel(const shader::ExactView& view) {
  return view.forward.w > 0;
}

float depthOf(const shader::ExactView& view, float near) {
  return isParallel(view) ? view.near + (1 - near) / view.forward.w : view.near / near;
}

std::optional<glm::dvec2> pixelOf(const shader::ExactView& view, const glm::dvec3& place) {
  const glm::dvec3 from = place - glm::dvec3(glm::vec3(view.eye));
  if (!isParallel(view)) return pixelOfDirection(view, from);
  return 0.5 * glm::dvec2(view.size) + glm::dvec2(glm::dot(from, glm::dvec3(glm::vec3(view.across))),
                                                  glm::dot(from, glm::dvec3(glm::vec3(view.down))));
}

std::optional<glm::dvec2> pixelOfDirection(const shader::ExactView& view, const glm::dvec3& direction) {
  const double depth = glm::dot(direction, glm::dvec3(glm::vec3(view.forward)));
  if (isParallel(view) || !(depth > 1e-9)) return std::nullopt;
  return glm::dvec2(glm::dot(direction, glm::dvec3(glm::vec3(view.across))),
                    glm::dot(direction, glm::dvec3(glm::vec3(view.down)))) /
         depth;
}

glm::vec3 placeOf(const shader::ExactView& view, glm::vec2 pixel, float depth) {
  const glm::vec3 ray =
      glm::vec3(view.ray) + pixel.x * glm::vec3(view.rayAcross) + pixel.y * glm::vec3(view.rayDown);
  return glm::vec3(view.eye) + (isParallel(view) ? ray + depth * glm::vec3(view.forward) : depth * ray);
}

glm::ivec2 rowsTowardsGround(const shader::ExactView& view, float height, int step) {
  if (isParallel(view)) return {0, (view.rows.y - view.rows.x + step - 1) / step * step};
  const float side = view.eye.y > height ? -1.0F : 1.0F;  // sign of y of the rays that may hit the ground
  const int count = (view.rows.y - view.rows.x + step - 1) / step;
  glm::ivec2 rows(0);
  for (int row = 0; row < count; ++row) {
    float maximum = -1;  // max of side * y over the corners of the row
    for (const int corner : {0, 1, 2, 3}) {
      const auto x = static_cast<float>((corner & 1) * view.size.x);
      const auto y = static_cast<float>(view.rows.x + (row + (corner >> 1)) * step);
      maximum = std::max(maximum, side * (view.ray.y + view.rayAcross.y * x + view.rayDown.y * y));
    }
    constexpr float slack = 1e-4F;  // tolerance for rounding errors
    if (maximum < -slack) continue;
    if (rows.y == 0) rows.x = row * step;
    rows.y = (row + 1) * step;
  }
  return rows;
}

glm::vec4 groundNearnessOf(const shader::ExactView& view, float height) {
  // A ray of depth 1 descends by -y, so the ground has the depth (height - eye.y) / y. Therefore near /
  // depth is affine in the pixel position.
  const float down = height - view.eye.y;
  if (isParallel(view)) return nearOfLevel(view, down);
  if (std::abs(down) < 1e-6F) return {1e30F, 0, 0, 0};
  const float across = view.near * view.rayAcross.y / down;
  const float below = view.near * view.rayDown.y / down;
  const float corner = view.near * view.ray.y / down;
  const float half = 0.5F * (std::abs(across) + std::abs(below));
  const auto size = glm::vec2(view.size);
  constexpr float slack = 1e-5F;  // relative rounding error of the terms
  const float terms = std::abs(corner) + std::abs(across) * size.x + std::abs(below) * size.y;
  return {corner + 0.5F * (across + below), across, below, half + slack * terms};
}

glm::vec3 rayBounds(const shader::ExactView& view) {
  constexpr float slack = 1e-5F;
  const auto size = glm::vec2(view.size);
  const glm::vec3 across = glm::abs(glm::vec3(view.rayAcross));
  const glm::vec3 down = glm::abs(glm::vec3(view.rayDown));
  const glm::vec3 terms = glm::abs(glm::vec3(view.ray)) + across * size.x + down * size.y;
  const glm::vec3 within = 0.5F * (across + down) + slack * terms;
  return view.near * glm::vec3(std::max(terms.x, terms.z), within.x, within.z);
}

}  // namespace simreel::draw
