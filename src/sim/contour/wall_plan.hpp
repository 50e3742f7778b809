#pragma once
#include "glsl/common/cpp.hpp"
#include "sim/contour/solid.hpp"

#include <vector>

#include <glm/vec3.hpp>

namespace simreel::shader {
#include "glsl/contour/wall_types.glsl"
}  // namespace simreel::shader

namespace simreel::sim {

/// Who collides with a solid, and how.
struct WallContact {
  float margin = 0;    ///< m, kept from it
  float bounce = 0;    ///< fraction of the speed of impact that is given back
  double seconds = 1;  ///< of a substep
};

/// Squares of a solid that a margin reaches over at most. Three rounds through the squares around, for each
/// of 17 prisms, are 35,000 loops then; a software driver ends a shader's loops after 65,535.
inline constexpr int maxWallSquares = 12;

/// What those that collide with a solid are told of it (glsl/contour/wall_model.glsl); shared with the CPU
/// twins. `heights` (m): of the classes; `position` (m): middle of the lowest face; `grip` (1/s): rate at
/// which tangential velocity is lost in contact. A thousandth of a square is kept in any case, so that
/// rounding puts nothing into a wall. Stops where the margin is wider than maxWallSquares.
[[nodiscard]] shader::WallGrid wallGrid(const SolidShape& shape, const std::vector<float>& heights,
                                        const glm::vec3& position, float grip, const WallContact& contact);

}  // namespace simreel::sim
