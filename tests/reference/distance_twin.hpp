#pragma once
#include "sim/collide/mesh_colliders.hpp"

#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// The distance fields of a scene's rigid meshes on the CPU: the kernels' model (glsl/collide/distance
/// compiled as C++). Equals the GPU bit for bit.
struct DistanceTwin {
  explicit DistanceTwin(simreel::sim::MeshColliderPlan plan);

  /// Prepares the frame that starts at `time` (s).
  void beginFrame(double time, int substeps, double substepSeconds) {
    steps = plan.frame(time, substeps, substepSeconds);
  }

  simreel::sim::MeshColliderPlan plan;
  std::vector<glm::uvec4> cells;
  std::vector<simreel::shader::MeshColliders> steps;  ///< collider data of each substep of the frame
};

/// Returns the first mesh's field at a point of the mesh's own space: the gradient in xyz and the distance
/// in w; w is 1e9 outside the field.
[[nodiscard]] glm::vec4 distanceTwinAt(const DistanceTwin& twin, const glm::vec3& place);

/// Returns the signed distance of a point in the mesh's own space by the kernels' search, without a grid.
[[nodiscard]] float distanceTo(const simreel::sim::DistancePlan& plan, const glm::vec3& place);
