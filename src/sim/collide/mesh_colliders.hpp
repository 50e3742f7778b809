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

/// The rigid meshes of a scene that collide: their fields, and how they move. Shared with the CPU twins.
class MeshColliderPlan {
 public:
  struct Part {
    std::string name;
    MeshParameters parameters;
    DistancePlan plan;
    int firstCell = 0;  ///< of all parts' cells
  };

  MeshColliderPlan() = default;
  /// Reads the meshes' files. The fields reach `reach` (m) around them. Throws what DistancePlan and
  /// loadMesh throw, and UserError(usage) for more meshes than the kernels hold.
  MeshColliderPlan(const scene::Scene& scene, double reach);

  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }
  [[nodiscard]] int count() const { return static_cast<int>(parts_.size()); }
  [[nodiscard]] int cellCount() const;
  /// What each of `substeps` of the frame that starts at `time` (s) is told, at its end.
  [[nodiscard]] std::vector<shader::MeshColliders> frame(double time, int substeps,
                                                         double substepSeconds) const;

 private:
  std::vector<Part> parts_;
};

/// Parameters of objects that rigid meshes touch.
struct TouchesMeshes {
  virtual ~TouchesMeshes() = default;
  /// Distance (m) that it keeps from them; negative: none touches it.
  [[nodiscard]] virtual double touchMargin() const = 0;

 protected:
  TouchesMeshes() = default;
  TouchesMeshes(const TouchesMeshes&) = default;
  TouchesMeshes& operator=(const TouchesMeshes&) = default;
  TouchesMeshes(TouchesMeshes&&) = default;
  TouchesMeshes& operator=(TouchesMeshes&&) = default;
};

/// The greatest margin (m) of what may touch a mesh of the scene; below 0: nothing does.
[[nodiscard]] double meshReach(const scene::Scene& scene);

}  // namespace simreel::sim
