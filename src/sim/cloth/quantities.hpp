#pragma once
#include "sim/cloth/parameters.hpp"

#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Softening of constraints that keep energy (glsl/cloth/keeping.glsl). The compliance of a line's links
/// grows by `lines` times seconds^2 times the inverse masses; pairs use at least pairSoftening in place of
/// `lines`. If `lines` is 0, there is no softening.
struct Softness {
  double lines = 0;
  double seconds = 0;
};

/// Returns the positions half a substep earlier, where a substep takes `seconds`. The conserved energy must
/// be measured in the middle of the last substep, because semi-implicit Euler yields the velocities at that
/// time.
[[nodiscard]] std::vector<glm::vec4> beforeHalf(std::span<const glm::vec4> positions,
                                                std::span<const glm::vec4> velocities, double seconds);

/// Returns the velocities with which particles actually moved in the last substep: v - p / 2, where v is
/// the stored velocity and p the trend left by constraints that do not keep energy
/// (glsl/cloth/motion.glsl). A particle that hangs at rest has v = p / 2, which is half a substep of
/// gravity, pointing upwards. Pinned particles (w = 0 in `positions`) keep their stored velocity.
[[nodiscard]] std::vector<glm::vec4> actualVelocities(std::span<const glm::vec4> positions,
                                                      std::span<const glm::vec4> velocities,
                                                      std::span<const glm::vec4> trends);

/// Returns the values of ClothParameters::quantities() for a state, in the order of quantities().
/// - Pinned particles count with the mass given by the parameters; while pinned they have no velocity.
/// - `positions` (m) and `velocities` (m/s) have size.x * size.y elements, x fastest; w of a position is
///   the inverse mass (1/kg), which is used with `softness`.
/// - Gravity is evaluated at `time` (s).
[[nodiscard]] std::vector<double> measureCloth(const ClothParameters& parameters,
                                               std::span<const glm::vec4> positions,
                                               std::span<const glm::vec4> velocities, double time,
                                               const Softness& softness = {});

}  // namespace simreel::sim
