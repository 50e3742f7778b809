#pragma once
#include "sim/collide/mesh_colliders.hpp"

#include <vector>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

/// CPU twin of the distance fields of a scene's rigid meshes. It runs the kernels' own model
/// (glsl/collide/distance compiled as C++). Equals the GPU bit for bit.
struct DistanceTwin {
  explicit DistanceTwin(simreel::sim::MeshColliderPlan plan);

  /// Prepares the substeps of the frame that starts at `time` (seconds).
  void beginFrame(double time, int substeps, double substepSeconds) {
    steps = plan.frame(time, substeps, substepSeconds);
  }

  simreel::sim::MeshColliderPlan plan;
  std::vector<glm::uvec4> cells;
  std::vector<simreel::shader::MeshColliders> steps;  ///< one element per substep of the frame
};

/// Returns the first mesh's distance field at a point in the mesh's coordinates. xyz is the gradient, w the
/// distance in metres. w is 1e9 outside the field.
[[nodiscard]] glm::vec4 distanceTwinAt(const DistanceTwin& twin, const glm::vec3& place);

/// Returns the signed distance of a point in the mesh's coordinates, by the kernels' tree search and
/// without a grid.
[[nodiscard]] float distanceTo(const simreel::sim::DistancePlan& plan, const glm::vec3& place);
