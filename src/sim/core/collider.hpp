#pragma once
#include "scene/value/animated.hpp"
#include "sim/core/carrier.hpp"

#include <array>
#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Something solid that may move along keyframes.
struct ColliderShape {
  enum class Kind { sphere, capsule, plane };
  Kind kind = Kind::sphere;
  scene::Animated<glm::vec3> position;  ///< centre, m; a point of the plane
  scene::Animated<glm::vec3> rotation;  ///< degrees; a capsule lies along local y, a plane faces local y
  float radius = 1.0F;                  ///< m
  float length = 0.0F;                  ///< m between the centres of a capsule's ends
  float grip = 25.3F;                   ///< 1/s at which tangential velocity is lost in contact
  std::optional<double> friction;       ///< Coulomb's coefficient, instead of `grip`
  /// Of a capsule that a bone carries: in its space lie `ends`, and position, rotation and length are
  /// unused; the radius is scaled, too.
  Carrier carrier = {};
  std::array<glm::vec3, 2> ends = {};  ///< m
};

/// The ends of a capsule that a bone carries, and its radius there.
struct CarriedCapsule {
  std::array<glm::dvec3, 2> ends;
  double radius;
};
[[nodiscard]] CarriedCapsule carriedAt(const ColliderShape& shape, double time);

/// Rotation by degrees about x, then y, then z (R = Rz Ry Rx), through the exact sine: same bits
/// everywhere.
[[nodiscard]] glm::mat4 rotationMatrix(const glm::vec3& degrees);

}  // namespace simreel::sim
