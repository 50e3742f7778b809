#pragma once
#include "sim/core/collider.hpp"
#include "sim/mesh/deform_parameters.hpp"
#include "sim/mesh/parameters.hpp"

#include <vector>

namespace simreel::sim {

/// What the deformation of a mesh is told of a moment; the same for every technique.
class DeformPlan {
 public:
  /// `name` stands in messages. Throws UserError(usage) when the scene has more spheres and capsules than
  /// the shaders hold while the mesh gives way to them, or when waves are too short for exact sines at the
  /// mesh's size.
  DeformPlan(const std::string& name, const MeshParameters& parameters, const Mesh& mesh,
             const std::vector<ColliderShape>& colliders);

  [[nodiscard]] shader::DeformStep at(double time) const;
  /// The same with each sphere swept over its way from `before` to `now`, so that a trail has no gaps.
  [[nodiscard]] shader::DeformStep swept(double before, double now) const;
  /// Of the trail; {2, 2} where there is none.
  [[nodiscard]] glm::ivec2 trailCells() const { return footprints_.cells; }
  [[nodiscard]] bool hasTrail() const { return footprints_.on; }

 private:
  void checkPhases(const std::string& name) const;
  [[nodiscard]] static shader::Presser presserBetween(const glm::vec3& a, const glm::vec3& b, float radius);
  [[nodiscard]] shader::Presser presser(const ColliderShape& shape, double time) const;
  void measureTrail();

  MeshParameters parameters_;
  std::vector<ColliderShape> pressers_;
  int vertices_;
  glm::vec3 low_, high_;     ///< m, of the mesh at rest
  Footprints footprints_{};  ///< with all that the shaders are told of the trail
};

}  // namespace simreel::sim
