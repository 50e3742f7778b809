#pragma once
#include "sim/cloth/parameters.hpp"

#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// How much softer constraints that keep energy are than their compliance: by `lines`, pairs at least by
/// pairSoftening, times seconds^2 times inverse masses (glsl/cloth/keeping.glsl). 0: they are not.
struct Softness {
  double lines = 0;
  double seconds = 0;
};

/// Where particles were half a substep of `seconds` before. Energy that is kept is measured there, in the
/// middle of the last substep: semi-implicit Euler gives velocities of then.
[[nodiscard]] std::vector<glm::vec4> beforeHalf(std::span<const glm::vec4> positions,
                                                std::span<const glm::vec4> velocities, double seconds);

/// Velocities at which particles actually moved in the last substep, from those and the trends that
/// constraints without kept energy leave (glsl/cloth/motion.glsl): v - p / 2. What hangs at rest has v = p
/// / 2, half a substep of gravity upwards. Pinned particles (w = 0 of `positions`) keep theirs.
[[nodiscard]] std::vector<glm::vec4> actualVelocities(std::span<const glm::vec4> positions,
                                                      std::span<const glm::vec4> velocities,
                                                      std::span<const glm::vec4> trends);

/// ClothParameters::quantities() of a state, in that order. Pinned particles count with the parameter's
/// mass; while pinned they have no velocity. `positions` (m) and `velocities` (m/s): size.x
/// * size.y elements, x fastest, w inverse masses (1/kg), used with `softness`. Gravity is that of `time`
/// (s).
[[nodiscard]] std::vector<double> measureCloth(const ClothParameters& parameters,
                                               std::span<const glm::vec4> positions,
                                               std::span<const glm::vec4> velocities, double time,
                                               const Softness& softness = {});

}  // namespace simreel::sim
