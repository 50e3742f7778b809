#pragma once
#include "gl/element_array.hpp"
#include "gl/program.hpp"
#include "sim/collide/mesh_colliders.hpp"
#include "sim/core/port.hpp"
#include "sim/core/step_blocks.hpp"

#include <string>

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
  void make(const MeshColliderPlan::Part& part);

  MeshColliderPlan plan_;
  gl::WordsArray cells_;
};

/// What an object that touches rigid meshes has of them: what each of its substeps is told.
class MeshTouch {
 public:
  MeshTouch() = default;
  /// `fields` null: the scene has none.
  MeshTouch(const std::string& name, const DistanceFields* fields, int substeps, double substepSeconds);

  [[nodiscard]] int count() const { return fields_ == nullptr ? 0 : fields_->plan().count(); }
  /// MESHES, for kernels that include glsl/collide/field_array.glsl; those that touch nothing define none.
  void addDefines(gl::Defines& defines) const;
  /// Stops unless the kernel's block is laid out as here.
  void check(const gl::Program& kernel) const;
  /// For the frame that starts at `time` (s).
  void beginFrame(double time);
  void bind(int substep) const;

 private:
  const DistanceFields* fields_ = nullptr;
  int substeps_ = 0;
  double substepSeconds_ = 0;
  StepBlocks<shader::MeshColliders> steps_;
};

}  // namespace simreel::sim
