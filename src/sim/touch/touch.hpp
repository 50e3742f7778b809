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

/// What kernels of cloth and particles are given of all that they meet beside shapes, a part of their
/// interfaces. What the scene lacks is left empty.
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
  gl::Range<"COLLIDERS", 0, shader::maxColliders> colliders = {};  ///< for software drivers
};

/// Rigid meshes, heights and walls that an object of a scene meets, and the wind around it.
class Touch {
 public:
  struct Wanted {
    std::string walls, wind;       ///< objects; empty: none
    bool solids = true;            ///< meets rigid meshes and heights
    float margin = 0, bounce = 0;  ///< as WallContact
    int colliders = 0;             ///< shapes
    int substeps = 1;              ///< a frame
    double substepSeconds = 1;
  };
  Touch() = default;
  /// Throws UserError(usage) where the margin is too wide for the walls.
  Touch(const std::string& name, const Setting& setting, const Wanted& wanted);

  [[nodiscard]] int meshCount() const { return fields_ == nullptr ? 0 : fields_->plan().count(); }
  /// True where it meets anything but shapes.
  [[nodiscard]] bool meets() const { return meshCount() > 0 || heights_ != nullptr || walls_ != nullptr; }
  /// For the frame that starts at `time` (s).
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
