#include "sim/collide/colliders.hpp"

#include "base/error.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>

namespace simreel::sim {

namespace {

/// Interpolates linearly between the values at a frame's beginning and end.
template <class T>
T partWay(const std::array<T, 2>& ends, double now) {
  return ends[0] * (1 - now) + ends[1] * now;
}

}  // namespace

float keptOf(float rate, double seconds) {
  return shader::exactExp(static_cast<float>(-rate * seconds));
}

ColliderPlan::ColliderPlan(const char* kindName, std::vector<ColliderShape> shapes, int substeps,
                           double substepSeconds)
    : shapes_(std::move(shapes)), substeps_(substeps), substepSeconds_(substepSeconds) {
  if (shapes_.size() > shader::maxColliders)
    fail(ExitCode::usage,
         "{} collides with at most {} shapes, the scene has {}; set \"collides\": false on some", kindName,
         shader::maxColliders, shapes_.size());
}

namespace {

/// Returns infinity for a plane.
double radiusOf(const ColliderShape& shape) {
  if (shape.kind == ColliderShape::Kind::plane) return std::numeric_limits<double>::infinity();
  return shape.carrier ? carriedAt(shape, 0).radius : shape.radius;
}

}  // namespace

bool ColliderPlan::isThin(const ColliderShape& shape, double edge, double margin) {
  const bool ball = !shape.carrier && shape.length == 0;
  return radiusOf(shape) + margin < (ball ? 0.7 : 0.49) * edge;
}

int ColliderPlan::putThinLast(double edge, double margin, double minimum) {
  const auto isThick = [&](const ColliderShape& shape) {
    return !isThin(shape, edge, margin) && !(radiusOf(shape) + margin < minimum);
  };
  const auto thin = std::stable_partition(shapes_.begin(), shapes_.end(), isThick);
  return static_cast<int>(shapes_.end() - thin);
}

shader::Collider ColliderPlan::keyedAt(const ColliderShape& shape, double time) const {
  const auto ends = [&](double t) {
    const glm::vec3 up(rotationMatrix(shape.rotation.at(t))[1]);
    const glm::vec3 centre = shape.position.at(t);
    const glm::vec3 reach = up * (0.5F * shape.length);
    return std::array{centre - reach, centre + reach, up};
  };
  const auto now = ends(time);
  const auto before = ends(time - substepSeconds_);
  const auto rate = static_cast<float>(1.0 / substepSeconds_);
  shader::Collider c{};
  c.grip = keptOf(shape.grip, substepSeconds_);
  c.friction = static_cast<float>(shape.friction.value_or(-1.0));
  if (shape.kind == ColliderShape::Kind::plane) {
    const glm::vec3 n = now[2];
    const glm::vec3 p = shape.position.at(time);
    c.a = glm::vec4(n, 0);
    c.reach = n.x * p.x + n.y * p.y + n.z * p.z;
    c.plane = 1;
    return c;
  }
  c.a = glm::vec4(now[0], 0);
  c.b = glm::vec4(now[1], 0);
  c.velocityA = glm::vec4((now[0] - before[0]) * rate, 0);
  c.velocityB = glm::vec4((now[1] - before[1]) * rate, 0);
  c.reach = shape.radius;
  c.perLengthSquared = shape.length > 0 ? 1.0F / (shape.length * shape.length) : 0.0F;
  return c;
}

shader::Collider ColliderPlan::carriedIn(const ColliderShape& shape,
                                         const std::array<CarriedCapsule, 2>& ends, int substep) const {
  const double now = static_cast<double>(substep + 1) / substeps_;
  const double perFrame = 1.0 / (substeps_ * substepSeconds_);
  shader::Collider c{};
  const auto side = [&](std::size_t end, glm::vec4& place, glm::vec4& velocity) {
    const std::array<glm::dvec3, 2> way = {ends[0].ends[end], ends[1].ends[end]};
    place = glm::vec4(glm::vec3(partWay(way, now)), 0);
    velocity = glm::vec4(glm::vec3((way[1] - way[0]) * perFrame), 0);
  };
  side(0, c.a, c.velocityA);
  side(1, c.b, c.velocityB);
  const glm::dvec3 axis(c.b - c.a);
  const double squared = axis.x * axis.x + axis.y * axis.y + axis.z * axis.z;
  c.perLengthSquared = squared > 1e-12 ? static_cast<float>(1.0 / squared) : 0.0F;
  c.reach = static_cast<float>(partWay(std::array{ends[0].radius, ends[1].radius}, now));
  c.grip = keptOf(shape.grip, substepSeconds_);
  c.friction = static_cast<float>(shape.friction.value_or(-1.0));
  return c;
}

std::vector<std::vector<shader::Collider>> ColliderPlan::frame(double time) const {
  const double end = time + substeps_ * substepSeconds_;
  std::vector<std::array<CarriedCapsule, 2>> ends(shapes_.size());
  for (std::size_t c = 0; c < shapes_.size(); ++c)
    if (shapes_[c].carrier) ends[c] = {carriedAt(shapes_[c], time), carriedAt(shapes_[c], end)};
  std::vector<std::vector<shader::Collider>> steps(static_cast<std::size_t>(substeps_));
  for (int i = 0; i < substeps_; ++i)
    for (std::size_t c = 0; c < shapes_.size(); ++c)
      steps[static_cast<std::size_t>(i)].push_back(
          shapes_[c].carrier ? carriedIn(shapes_[c], ends[c], i)
                             : keyedAt(shapes_[c], time + (i + 1) * substepSeconds_));
  return steps;
}

}  // namespace simreel::sim
