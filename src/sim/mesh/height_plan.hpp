#pragma once
#include "glsl/common/cpp.hpp"
#include "sim/mesh/parameters.hpp"

namespace simreel::shader {
#include "glsl/mesh/height_types.glsl"
}  // namespace simreel::shader

namespace simreel::sim {

/// Description of a height-field mesh for objects that fall onto it; the CPU references use it, too. The
/// mesh is a plane that does not move, rotate or scale.
class HeightPlan {
 public:
  HeightPlan(const MeshParameters& mesh, double frameSeconds);

  /// Returns the grid at the end of substep `index` of `substeps`. `margin` (metres) is the distance that
  /// objects keep above the surface. `bounce` is the fraction of the impact speed that remains after the
  /// bounce.
  [[nodiscard]] shader::HeightGrid at(int index, int substeps, float margin, float bounce) const;
  [[nodiscard]] float lift() const { return lift_; }  ///< height of the mesh's origin in metres
  [[nodiscard]] glm::ivec2 size() const { return grid_.size; }

 private:
  shader::HeightGrid grid_{};
  float lift_;
  float grip_;  ///< decay rate (1/s) of the tangential velocity of objects that slide on the surface
  double frameSeconds_;
};

}  // namespace simreel::sim
