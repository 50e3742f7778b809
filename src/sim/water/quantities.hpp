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

/// The quantities of floats alone: "displaced" and those after it.
[[nodiscard]] std::vector<double> measureFloats(const WaterPlan& plan, std::span<const glm::vec4> floats);

/// What makes sums over cells of depth, h |u|^2 / 2, h (level + bed) / 2 and wet cells the volume, both
/// energies and the wet area, as the quantities have them.
[[nodiscard]] glm::vec4 waterSumFactors(const WaterParameters& parameters);

}  // namespace simreel::sim
