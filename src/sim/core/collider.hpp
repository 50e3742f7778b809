#pragma once
#include "scene/value/animated.hpp"
#include "sim/core/carrier.hpp"

#include <array>
#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Solid collision shape, optionally animated by keyframes.
struct ColliderShape {
  enum class Kind { sphere, capsule, plane };
  Kind kind = Kind::sphere;
  scene::Animated<glm::vec3> position;  ///< Centre in metres; for a plane, a point on the plane.
  scene::Animated<glm::vec3>
      rotation;         ///< Rotation in degrees; a capsule's axis is local y, a plane's normal is local y.
  float radius = 1.0F;  ///< Radius of a sphere or capsule, in metres.
  float length = 0.0F;  ///< Distance in metres between the centres of a capsule's two end caps.
  float grip = 25.3F;   ///< Decay rate (1/s) of the tangential velocity in contact.
  std::optional<double> friction;  ///< Coulomb friction coefficient; if set, it replaces `grip`.
  /// Bone that carries a capsule; empty for other shapes. With a carrier, `ends` are in the bone's local
  /// space, `position`, `rotation` and `length` are unused, and the bone's scale also scales `radius`.
  Carrier carrier = {};
  std::array<glm::vec3, 2> ends = {};  ///< Centres of the two end caps, in metres.
};

/// World-space end cap centres and radius (metres) of a capsule carried by a bone.
struct CarriedCapsule {
  std::array<glm::dvec3, 2> ends;
  double radius;
};
[[nodiscard]] CarriedCapsule carriedAt(const ColliderShape& shape, double time);

/// Returns the rotation by Euler angles in degrees about x, then y, then z (R = Rz Ry Rx). Uses the exact
/// sine, so the result has the same bits on every machine.
[[nodiscard]] glm::mat4 rotationMatrix(const glm::vec3& degrees);

}  // namespace simreel::sim
