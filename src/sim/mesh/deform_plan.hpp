#pragma once
#include "sim/core/collider.hpp"
#include "sim/mesh/deform_parameters.hpp"
#include "sim/mesh/parameters.hpp"

#include <vector>

namespace simreel::sim {

/// Computes the uniform data of a mesh's deformation at a given time. The data are the same for every
/// technique.
class DeformPlan {
 public:
  /// `name` appears in messages. Throws UserError(usage) if the mesh reacts to colliders and the scene has
  /// more spheres and capsules than the shaders support, or if the waves are so short for the mesh's size
  /// that their phase exceeds the range of exact sines.
  DeformPlan(const std::string& name, const MeshParameters& parameters, const Mesh& mesh,
             const std::vector<ColliderShape>& colliders);

  [[nodiscard]] shader::DeformStep at(double time) const;
  /// Returns the data for the time `now`, with each sphere swept along its path since `before`, so that a
  /// trail has no gaps.
  [[nodiscard]] shader::DeformStep swept(double before, double now) const;
  /// Returns the number of cells of the footprint trail along x and z; {2, 2} if there is no trail.
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
  glm::vec3 low_, high_;     ///< bounds of the undeformed mesh in metres
  Footprints footprints_{};  ///< footprint parameters, including the derived trail data for the shaders
};

}  // namespace simreel::sim
