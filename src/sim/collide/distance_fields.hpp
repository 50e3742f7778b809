#pragma once
#include "gl/element_array.hpp"
#include "sim/collide/mesh_colliders.hpp"
#include "sim/core/port.hpp"

namespace simreel::sim {

/// The distance fields of a scene's rigid meshes on the GPU, made there once.
class DistanceFields {
 public:
  static const PortInfo port;

  /// Throws UserError(device) where the device's buffers are too small.
  explicit DistanceFields(MeshColliderPlan plan);

  [[nodiscard]] const MeshColliderPlan& plan() const { return plan_; }
  /// A cell an element, as glsl/collide/field_model.glsl reads them.
  [[nodiscard]] const gl::WordsArray& cells() const { return cells_; }

 private:
  void make(const MeshColliderPlan::Part& mesh);

  MeshColliderPlan plan_;
  gl::WordsArray cells_;
};

}  // namespace simreel::sim
