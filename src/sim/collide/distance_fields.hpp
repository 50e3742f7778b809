#pragma once
#include "gl/element_array.hpp"
#include "sim/collide/mesh_colliders.hpp"
#include "sim/core/port.hpp"

namespace simreel::sim {

/// GPU distance fields of a scene's rigid meshes, computed once.
class DistanceFields {
 public:
  static const PortInfo port;

  /// Throws UserError(device) if the fields exceed the device's buffer limits.
  explicit DistanceFields(MeshColliderPlan plan);

  [[nodiscard]] const MeshColliderPlan& plan() const { return plan_; }
  /// Returns the cells of all fields, one cell per element, as glsl/collide/field_model.glsl reads them.
  [[nodiscard]] const gl::WordsArray& cells() const { return cells_; }

 private:
  void make(const MeshColliderPlan::Part& mesh);

  MeshColliderPlan plan_;
  gl::WordsArray cells_;
};

}  // namespace simreel::sim
