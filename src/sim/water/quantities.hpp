#pragma once
#include "sim/water/plan.hpp"

#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Returns the values of WaterParameters::quantities() for a state, in the order of quantities(). Sums are
/// computed in double with x fastest, so equal states give equal numbers. `cells` has the format of
/// WaterPlan::firstCells(), and `floats` has the format of FloatPlan::first().
[[nodiscard]] std::vector<double> measureWater(const WaterPlan& plan, std::span<const glm::vec4> cells,
                                               std::span<const glm::vec4> floats = {});

/// Returns only the quantities of floating bodies: "displaced" and the quantities after it.
[[nodiscard]] std::vector<double> measureFloats(const WaterPlan& plan, std::span<const glm::vec4> floats);

/// Returns the factors that convert sums over cells to quantities: depth to volume, h |u|^2 / 2 to kinetic
/// energy, h (level + bed) / 2 to potential energy, and the number of wet cells to wet area. h is the depth
/// and u the velocity.
[[nodiscard]] glm::vec4 waterSumFactors(const WaterParameters& parameters);

}  // namespace simreel::sim
