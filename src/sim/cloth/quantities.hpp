#pragma once
#include "sim/cloth/parameters.hpp"

#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// ClothParameters::quantities() of a state, in that order. Pinned particles count with the parameter's
/// mass; while pinned they have no velocity. `positions` (m) and `velocities` (m/s): size.x
/// * size.y elements, x fastest, w unused. Gravity is that of `time` (s).
[[nodiscard]] std::vector<double> measureCloth(const ClothParameters& parameters,
                                               std::span<const glm::vec4> positions,
                                               std::span<const glm::vec4> velocities, double time);

}  // namespace simreel::sim
