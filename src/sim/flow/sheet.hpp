#pragma once
#include "sim/core/drawable.hpp"
#include "sim/core/port.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/mesh/buffers.hpp"

#include <string>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Rectangle of a flow in the world, coloured by a field on the same grid.
class FieldSheet {
 public:
  /// The skin of `material` names the field (scene::Papered).
  FieldSheet(const std::string& name, const FluidPlane& plane, glm::ivec2 size,
             const scene::Material& material);

  /// Returns the rectangle as a surface. Its pointers are valid while this object exists.
  [[nodiscard]] Surface surface() const;
  [[nodiscard]] MeshTable table() const { return buffers_.table(glm::mat4(1)); }

 private:
  scene::Material material_;
  MeshBuffers buffers_;
};

}  // namespace simreel::sim
