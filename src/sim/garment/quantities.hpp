#pragma once
#include "sim/garment/plan.hpp"

#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// ClothParameters::quantities() of a state of cloth of a mesh, in that order; "stretch" is the greatest of
/// its faces' along weft or warp, and faces store energy by stiffnessOf() a substep. Positions' w is the
/// inverse mass. Pinned vertices count with their mass. Gravity is that of `time` (s).
[[nodiscard]] std::vector<double> measureGarment(const GarmentPlan& plan,
                                                 std::span<const glm::vec4> positions,
                                                 std::span<const glm::vec4> velocities, double time);

}  // namespace simreel::sim
