#pragma once
#include "glsl/common/cpp.hpp"
#include "sim/mesh/parameters.hpp"

namespace simreel::shader {
#include "glsl/mesh/height_types.glsl"
}  // namespace simreel::shader

namespace simreel::sim {

/// What those that fall onto a mesh are told of it; shared with the CPU twins. The mesh is a plane that
/// stays where it is, neither turned nor scaled.
class HeightPlan {
 public:
  HeightPlan(const MeshParameters& mesh, double frameSeconds);

  /// At the end of substep `index` of `substeps`. `margin` (m) is kept above it; `bounce`: fraction of the
  /// speed of impact that is given back.
  [[nodiscard]] shader::HeightGrid at(int index, int substeps, float margin, float bounce) const;
  [[nodiscard]] float lift() const { return lift_; }  ///< m, the mesh's origin above 0
  [[nodiscard]] glm::ivec2 size() const { return grid_.size; }

 private:
  shader::HeightGrid grid_{};
  float lift_;
  float grip_;  ///< 1/s
  double frameSeconds_;
};

}  // namespace simreel::sim
