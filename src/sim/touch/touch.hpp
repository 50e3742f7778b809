#pragma once
#include "gl/kernel/kernel.hpp"
#include "glsl/common/cpp.hpp"
#include "sim/collide/colliders.hpp"
#include "sim/collide/distance_fields.hpp"
#include "sim/contour/walls.hpp"
#include "sim/core/step_blocks.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/mesh/height_field.hpp"

#include <string>

namespace simreel::sim {

struct Setting;

/// Kernel inputs for collisions of cloth and particles with everything except analytic shapes, and for
/// wind. Inputs that the scene does not have stay empty.
struct TouchPart {
  gl::Block<"MeshColliderBlock", shader::MeshColliders> meshes = {};
  gl::In<"fieldCells"> fieldCells = {};
  HeightPart heights = {};
  WallPart walls = {};
  FluidWindPart wind = {};
};
struct TouchVariant {
  gl::Range<"MESHES", 0, shader::maxMeshColliders> meshes = {};
  gl::Switch<"HEIGHTS"> heights = {};
  WallVariant walls = {};
  gl::Flag<"WIND"> wind = {};
  gl::Range<"COLLIDERS", 0, shader::maxColliders> colliders = {};  ///< used by software drivers only
};

/// Rigid meshes, height fields and walls that an object of a scene collides with, and the wind around it.
class Touch {
 public:
  struct Wanted {
    std::string walls, wind;       ///< names of the objects that provide walls and wind; empty if none
    bool solids = true;            ///< true if the object collides with rigid meshes and height fields
    float margin = 0, bounce = 0;  ///< collision margin and bounce as in WallContact
    int colliders = 0;             ///< number of analytic shapes
    int substeps = 1;              ///< number of substeps per frame
    double substepSeconds = 1;
  };
  Touch() = default;
  /// Throws UserError(usage) if the margin is too large for the walls.
  Touch(const std::string& name, const Setting& setting, const Wanted& wanted);

  [[nodiscard]] int meshCount() const { return fields_ == nullptr ? 0 : fields_->plan().count(); }
  /// Returns true if the object collides with anything other than analytic shapes.
  [[nodiscard]] bool meets() const { return meshCount() > 0 || heights_ != nullptr || walls_ != nullptr; }
  /// Uploads the data of the frame that starts at `time` (seconds).
  void beginFrame(double time);
  [[nodiscard]] TouchVariant variant() const;
  [[nodiscard]] TouchPart at(int substep) const;
  [[nodiscard]] FluidWindPart wind() const { return wind_ != nullptr ? wind_->part() : FluidWindPart(); }

 private:
  Wanted wanted_;
  const DistanceFields* fields_ = nullptr;
  const HeightField* heights_ = nullptr;
  const Walls* walls_ = nullptr;
  const FluidWind* wind_ = nullptr;
  StepBlocks<shader::MeshColliders> steps_;
};

}  // namespace simreel::sim
