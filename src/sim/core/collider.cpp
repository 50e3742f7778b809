#include "sim/core/collider.hpp"

#include "sim/core/turn.hpp"

#include <cmath>

namespace simreel::sim {

glm::mat4 rotationMatrix(const glm::vec3& degrees) {
  const glm::vec2 aboutX = cosineAndSine(degrees.x);
  const glm::vec2 aboutY = cosineAndSine(degrees.y);
  const glm::vec2 aboutZ = cosineAndSine(degrees.z);
  const float cx = aboutX.x;
  const float sx = aboutX.y;
  const float cy = aboutY.x;
  const float sy = aboutY.y;
  const float cz = aboutZ.x;
  const float sz = aboutZ.y;
  // These are the columns of the matrix Rz Ry Rx.
  return {glm::vec4(cz * cy, sz * cy, -sy, 0),
          glm::vec4(cz * sy * sx - sz * cx, sz * sy * sx + cz * cx, cy * sx, 0),
          glm::vec4(cz * sy * cx + sz * sx, sz * sy * cx - cz * sx, cy * cx, 0), glm::vec4(0, 0, 0, 1)};
}

CarriedCapsule carriedAt(const ColliderShape& shape, double time) {
  const glm::dmat4 m = shape.carrier(time);
  const auto place = [&](const glm::vec3& end) { return glm::dvec3(m * glm::dvec4(glm::dvec3(end), 1)); };
  const glm::dvec3 across(m[0]);
  const double scale = std::sqrt(across.x * across.x + across.y * across.y + across.z * across.z);
  return {{place(shape.ends[0]), place(shape.ends[1])}, scale * shape.radius};
}

}  // namespace simreel::sim
