#pragma once
#include "glsl/common/cpp.hpp"
#include "sim/contour/solid.hpp"

#include <vector>

#include <glm/vec3.hpp>

namespace simreel::shader {
#include "glsl/contour/wall_types.glsl"
}  // namespace simreel::shader

namespace simreel::sim {

/// Collision parameters of an object that collides with a solid.
struct WallContact {
  float margin = 0;    ///< Minimum distance to the solid in metres.
  float bounce = 0;    ///< Fraction of the impact speed that remains after the bounce.
  double seconds = 1;  ///< Duration of a substep in seconds.
};

/// Maximum collision margin in squares of the solid. With this margin, three rounds over the surrounding
/// squares with 17 prisms per square take about 35,000 loop iterations. A software driver ends a shader's
/// loops after 65,535 iterations.
inline constexpr int maxWallSquares = 12;

/// Returns the collision data of a solid for objects that collide with it (glsl/contour/wall_model.glsl).
/// The CPU twins use it, too. `heights` are the heights of the classes in metres, `position` is the centre
/// of the lowest face in metres, and `grip` is the decay rate (1/s) of the tangential velocity in contact.
/// The margin is at least a thousandth of a square, so that rounding does not move objects into a wall.
/// Aborts if the margin exceeds maxWallSquares.
[[nodiscard]] shader::WallGrid wallGrid(const SolidShape& shape, const std::vector<float>& heights,
                                        const glm::vec3& position, float grip, const WallContact& contact);

}  // namespace simreel::sim
