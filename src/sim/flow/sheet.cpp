#include "sim/flow/sheet.hpp"

#include "sim/core/collider.hpp"
#include "sim/core/simulation.hpp"
#include "sim/grid/field_display.hpp"

#include <glm/mat4x4.hpp>

namespace simreel::sim {

namespace {

Mesh rectangle(const FluidPlane& plane, glm::ivec2 size) {
  const glm::mat4 turned = rotationMatrix(plane.rotation);
  const glm::vec3 right = 0.5F * plane.cell * static_cast<float>(size.x) * glm::vec3(turned[0]);
  const glm::vec3 up = 0.5F * plane.cell * static_cast<float>(size.y) * glm::vec3(turned[1]);
  Mesh mesh;
  for (const glm::vec2& corner : {glm::vec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
    mesh.positions.push_back(plane.position + (2 * corner.x - 1) * right + (1 - 2 * corner.y) * up);
    mesh.normals.emplace_back(turned[2]);
    mesh.uvs.push_back(corner);
  }
  mesh.indices = {0, 2, 1, 1, 2, 3};
  return mesh;
}

}  // namespace

FieldSheet::FieldSheet(const std::string& name, const FluidPlane& plane, glm::ivec2 size,
                       const scene::Material& material)
    : material_(material), buffers_(name, rectangle(plane, size)) {}

Surface FieldSheet::surface() const {
  Surface surface = buffers_.surface();
  surface.doubleSided = true;
  surface.material = &material_;
  return surface;
}

}  // namespace simreel::sim
