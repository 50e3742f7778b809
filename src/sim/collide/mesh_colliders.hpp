#pragma once
#include "glsl/common/cpp.hpp"
#include "scene/scene.hpp"
#include "sim/collide/distance_plan.hpp"
#include "sim/mesh/parameters.hpp"

#include <string>
#include <vector>

namespace simreel::shader {
#include "glsl/collide/field_types.glsl"
}  // namespace simreel::shader

namespace simreel::sim {

/// Distance fields and motion of a scene's rigid meshes that collide. The CPU references use it, too.
class MeshColliderPlan {
 public:
  struct Part {
    std::string name;
    MeshParameters parameters;
    DistancePlan plan;
    int firstCell = 0;  ///< index of the part's first cell among the cells of all parts
  };

  MeshColliderPlan() = default;
  /// Reads the files of the meshes. The fields extend beyond the meshes by `reach` (metres). Throws the
  /// errors of DistancePlan and loadMesh(), and UserError(usage) for more meshes than the kernels support.
  MeshColliderPlan(const scene::Scene& scene, double reach);

  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }
  [[nodiscard]] int count() const { return static_cast<int>(parts_.size()); }
  [[nodiscard]] int cellCount() const;
  /// Returns the meshes' data at the end of each of the `substeps` substeps of the frame that starts at
  /// `time` (seconds).
  [[nodiscard]] std::vector<shader::MeshColliders> frame(double time, int substeps,
                                                         double substepSeconds) const;

 private:
  std::vector<Part> parts_;
};

/// Parameters of objects that collide with rigid meshes.
struct TouchesMeshes {
  virtual ~TouchesMeshes() = default;
  /// Returns the distance (metres) that the object keeps from meshes; negative if it does not collide with
  /// them.
  [[nodiscard]] virtual double touchMargin() const = 0;

 protected:
  TouchesMeshes() = default;
  TouchesMeshes(const TouchesMeshes&) = default;
  TouchesMeshes& operator=(const TouchesMeshes&) = default;
  TouchesMeshes(TouchesMeshes&&) = default;
  TouchesMeshes& operator=(TouchesMeshes&&) = default;
};

/// Returns the maximum touchMargin() of the scene's objects in metres; negative if no object collides with
/// meshes.
[[nodiscard]] double meshReach(const scene::Scene& scene);

}  // namespace simreel::sim
