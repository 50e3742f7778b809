#pragma once
#include "sim/cloth_parameters.hpp"
#include "sim/simulation.hpp"

#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// What a cloth measures of its state, in the order of clothQuantityNames(). Pinned particles count with
/// the parameter's mass; while pinned they have no velocity. `positions` (m) and `velocities` (m/s): size.x
/// * size.y elements, x fastest, w unused. Gravity is that of `time` (s).
[[nodiscard]] std::vector<Quantity> clothQuantities(const ClothParameters& parameters,
                                                    std::span<const glm::vec4> positions,
                                                    std::span<const glm::vec4> velocities, double time);
[[nodiscard]] std::vector<const char*> clothQuantityNames();

}  // namespace simreel::sim
