#pragma once
#include "gl/program.hpp"
#include "sim/contour/solid.hpp"
#include "sim/core/port.hpp"

#include <string>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// A solid as others collide with it, in the state in which its latest make() left it.
class Walls {
 public:
  static const PortInfo port;

  /// Of a solid that stays where it is; `position` and `grip` as wallGrid() has them.
  Walls(std::string name, const Solid& solid, const glm::vec3& position, float grip);

  /// Throws UserError(usage) where that margin (m) reaches over more squares than kernels go through.
  void checkReach(const std::string& who, float margin) const;
  /// For glsl/contour/wall_array.glsl of a kernel.
  void bind() const;
  /// Tells a kernel what the solid is like now; `seconds` of a substep, others as WallContact has them.
  void tell(const gl::Program& kernel, double seconds, float margin, float bounce) const;
  [[nodiscard]] const Solid& solid() const { return *solid_; }

 private:
  std::string name_;
  const Solid* solid_;
  glm::vec3 position_;
  float grip_;
};

/// Defines of a kernel that includes wall_array.glsl; `walls` null: it meets none.
void addWallDefines(gl::Defines& defines, const Walls* walls);

}  // namespace simreel::sim
