#pragma once
#include "sim/water/plan.hpp"

#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// WaterParameters::quantities() of a state, in that order: sums in double, x fastest, so equal states give
/// equal numbers. `cells` as WaterPlan::firstCells(), `floats` as FloatPlan::first().
[[nodiscard]] std::vector<double> measureWater(const WaterPlan& plan, std::span<const glm::vec4> cells,
                                               std::span<const glm::vec4> floats = {});

}  // namespace simreel::sim
