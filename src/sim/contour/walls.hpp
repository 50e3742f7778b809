#pragma once
#include "gl/kernel/kernel.hpp"
#include "sim/contour/wall_plan.hpp"
#include "sim/core/port.hpp"
#include "sim/grid/field_part.hpp"

#include <string>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Part of a kernel interface: members of glsl/contour/wall_array.glsl, used if WALLS is 1.
struct WallPart {
  gl::Uniform<"wallGrid.corner", glm::vec2> corner;
  gl::Uniform<"wallGrid.spacing", float> spacing;
  gl::Uniform<"wallGrid.perSpacing", float> perSpacing;
  gl::Uniform<"wallGrid.bottom", float> bottom;
  gl::Uniform<"wallGrid.roof", float> roof;
  gl::Uniform<"wallGrid.reach", float> reach;
  gl::Uniform<"wallGrid.kept", float> kept;
  gl::Uniform<"wallGrid.bounce", float> bounce;
  gl::Uniform<"wallGrid.levelCount", int> levelCount;
  gl::Uniform<"wallGrid.ceiling", int> ceiling;
  gl::Uniform<"wallGrid.squares", int> squares;
  gl::Uniform<"wallGrid.samples", glm::ivec2> samples;
  gl::Uniforms<"wallGrid.heights", float, maxSolidLevels + 1> heights;
  gl::Uniforms<"wallGrid.levels", float, maxSolidLevels> levels;
  gl::Uniform<"rowElements", int> rowElements;
  gl::In<"wallClasses"> classes;
  FieldPart field;
};
struct WallVariant {
  gl::Switch<"WALLS"> walls;
  gl::Flag<"BRANCHES"> branches;
  FieldCells cells;
};

/// Collision data of a solid in the state of its latest make().
class Walls {
 public:
  static const PortInfo port;

  /// Creates the collision data for a solid at a fixed position. `position` and `grip` have the same
  /// meaning as for wallGrid().
  Walls(std::string name, const Solid& solid, const glm::vec3& position, float grip);

  /// Throws UserError(usage) if the margin (metres) covers more squares than the kernels support.
  void checkReach(const std::string& objectName, float margin) const;
  /// Returns the inputs that kernels need to collide with the solid in its current state.
  [[nodiscard]] WallPart part(const WallContact& contact) const;
  [[nodiscard]] WallVariant variant() const;

 private:
  std::string name_;
  const Solid* solid_;
  glm::vec3 position_;
  float grip_;
};

}  // namespace simreel::sim
