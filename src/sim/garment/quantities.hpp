#pragma once
#include "sim/garment/plan.hpp"

#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Returns the values of ClothParameters::quantities() for a state of mesh cloth, in the order of
/// quantities(). "stretch" is the maximum over the faces along weft or warp. The energy of the faces uses
/// stiffnessOf(). w of a position is the inverse mass. Pinned vertices count with their mass. Gravity is
/// evaluated at `time` (s).
[[nodiscard]] std::vector<double> measureGarment(const GarmentPlan& plan,
                                                 std::span<const glm::vec4> positions,
                                                 std::span<const glm::vec4> velocities, double time);

}  // namespace simreel::sim
