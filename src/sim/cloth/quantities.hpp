#pragma once
#include "sim/cloth/parameters.hpp"

#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// How much softer constraints that keep energy are than their compliance: by `lines` or pairSoftening
/// times seconds^2 times inverse masses (glsl/cloth/keeping.glsl). 0: they are not.
struct Softness {
  double lines = 0;
  double seconds = 0;
};

/// ClothParameters::quantities() of a state, in that order. Pinned particles count with the parameter's
/// mass; while pinned they have no velocity. `positions` (m) and `velocities` (m/s): size.x
/// * size.y elements, x fastest, w inverse masses (1/kg), used with `softness`. Gravity is that of `time`
/// (s).
[[nodiscard]] std::vector<double> measureCloth(const ClothParameters& parameters,
                                               std::span<const glm::vec4> positions,
                                               std::span<const glm::vec4> velocities, double time,
                                               const Softness& softness = {});

}  // namespace simreel::sim
