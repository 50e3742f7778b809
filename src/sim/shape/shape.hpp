#pragma once
#include "scene/dressed.hpp"
#include "scene/value/fields.hpp"
#include "sim/core/collider.hpp"
#include "sim/core/kind.hpp"
#include "sim/core/simulation.hpp"

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Parameters of the object kinds "sphere", "capsule" and "plane".
struct ShapeParameters : ObjectParameters, scene::HasFinish {
  explicit ShapeParameters(ColliderShape::Kind kind) {
    shape.kind = kind;
    shape.radius = kind == ColliderShape::Kind::plane     ? 0.0F
                   : kind == ColliderShape::Kind::capsule ? 0.1F
                                                          : 1.0F;
    shape.length = kind == ColliderShape::Kind::capsule ? 2.0F : 0.0F;
  }
  ColliderShape shape;
  glm::vec3 size{4, 0, 4};
  bool collides = true;
  bool visible = true;
  bool tiled = false;  ///< true if the plane has tiles where the scene gives no colour
  void describe(scene::Fields& fields) override;
  /// Returns the bounds of spheres and capsules at all position keys. Planes have no bounds, because they
  /// serve as ground.
  [[nodiscard]] std::optional<scene::Box> framed() const override;
  [[nodiscard]] std::optional<scene::Box> framedAlone() const override;
  /// Returns the tiles of a plane; nullopt for other shapes, and for scenes of version 1.
  [[nodiscard]] std::optional<scene::Material> look() const override;
  void ports(Ports& ports) const override;
};

[[nodiscard]] SimulationKind sphereKind();
[[nodiscard]] SimulationKind capsuleKind();
[[nodiscard]] SimulationKind planeKind();

}  // namespace simreel::sim
