#include "sim/collide/mesh_colliders.hpp"

#include "base/error.hpp"
#include "sim/collide/colliders.hpp"
#include "sim/core/collider.hpp"

#include <algorithm>
#include <cstddef>

#include <glm/mat4x4.hpp>

namespace simreel::sim {

namespace {

/// Position and orientation of a part. The scale is already included in the distance field.
struct Placed {
  glm::dvec3 axes[3];  ///< unit axes of the part's local space
  glm::dvec3 origin;
};

Placed placedAt(const MeshParameters& mesh, double time) {
  const glm::mat4 turn = rotationMatrix(mesh.rotation.at(time));
  return {{glm::dvec3(turn[0]), glm::dvec3(turn[1]), glm::dvec3(turn[2])},
          glm::dvec3(mesh.position.at(time))};
}

}  // namespace

MeshColliderPlan::MeshColliderPlan(const scene::Scene& scene, double reach) {
  for (const scene::Object& object : scene.objects) {
    const auto* mesh = dynamic_cast<const MeshParameters*>(object.parameters.get());
    if (mesh == nullptr || !mesh->collidesRigidly()) continue;
    if (parts_.size() == shader::maxMeshColliders) {
      if (reach < 0) return;
      fail(ExitCode::usage,
           "more than {} meshes collide; set \"collides\": false on some, or join files into one",
           shader::maxMeshColliders);
    }
    const int first = cellCount();
    parts_.push_back({object.name, *mesh,
                      DistancePlan(object.name, mesh->make(scene.seed), mesh->scale.at(0),
                                   mesh->distanceCells, std::max(0.0, reach)),
                      first});
  }
}

int MeshColliderPlan::cellCount() const {
  int cells = 0;
  for (const Part& part : parts_) cells += part.plan.cellCount();
  return cells;
}

std::vector<shader::MeshColliders> MeshColliderPlan::frame(double time, int substeps,
                                                           double substepSeconds) const {
  std::vector<shader::MeshColliders> steps(static_cast<std::size_t>(substeps));
  for (int i = 0; i < substeps; ++i) {
    shader::MeshColliders& step = steps[static_cast<std::size_t>(i)];
    step.count = count();
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      const Part& part = parts_[k];
      const Placed before = placedAt(part.parameters, time + i * substepSeconds);
      const Placed now = placedAt(part.parameters, time + (i + 1) * substepSeconds);
      shader::MeshCollider& c = step.meshes[k];
      for (int row = 0; row < 3; ++row) {
        const glm::dvec3& axis = now.axes[row];
        const double offset = axis.x * now.origin.x + axis.y * now.origin.y + axis.z * now.origin.z;
        c.into[row] = glm::vec4(glm::dvec4(axis, -offset));
        glm::dvec4 rate(0, 0, 0, now.origin[row] - before.origin[row]);
        for (int column = 0; column < 3; ++column)
          rate[column] = now.axes[column][row] - before.axes[column][row];
        c.rate[row] = glm::vec4(rate / substepSeconds);
      }
      c.corner = glm::vec4(part.plan.corner, 1.0F / part.plan.cell);
      c.cells = glm::ivec4(part.plan.cells, part.firstCell);
      c.cell = part.plan.cell;
      c.unit = part.plan.unit;
      c.grip = keptOf(part.parameters.grip, substepSeconds);
      c.friction = static_cast<float>(part.parameters.friction.value_or(-1.0));
    }
  }
  return steps;
}

double meshReach(const scene::Scene& scene) {
  double reach = -1;
  for (const scene::Object& object : scene.objects)
    if (const auto* parameters = dynamic_cast<const TouchesMeshes*>(object.parameters.get()))
      reach = std::max(reach, parameters->touchMargin());
  return reach;
}

}  // namespace simreel::sim
