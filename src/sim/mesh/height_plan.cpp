#include "sim/mesh/height_plan.hpp"

#include "sim/core/shader_code.hpp"

namespace simreel::sim {

HeightPlan::HeightPlan(const MeshParameters& mesh, double frameSeconds)
    : lift_(mesh.position.at(0).y), grip_(mesh.grip), frameSeconds_(frameSeconds) {
  const glm::vec3 middle = mesh.position.at(0);
  const glm::vec2 cells(mesh.resolution - 1);
  grid_.corner = {middle.x - 0.5F * mesh.size.x, middle.z - 0.5F * mesh.size.z};
  grid_.perCell = {cells.x / mesh.size.x, cells.y / mesh.size.z};
  grid_.size = mesh.resolution;
  grid_.perFrame = static_cast<float>(1.0 / frameSeconds);
}

shader::HeightGrid HeightPlan::at(int index, int substeps, float margin, float bounce) const {
  shader::HeightGrid grid = grid_;
  grid.progress = static_cast<float>(static_cast<double>(index + 1) / substeps);
  grid.kept = shader::exactExp(static_cast<float>(-grip_ * (frameSeconds_ / substeps)));
  grid.bounce = bounce;
  grid.margin = margin;
  return grid;
}

}  // namespace simreel::sim
