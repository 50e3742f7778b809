#pragma once
#include "sim/water/plan.hpp"

#include <span>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Returns the values of WaterParameters::quantities() for a state, in that order. Sums are in double with
/// x fastest, so equal states give equal numbers. Formats: `cells` as WaterPlan::firstCells(), `floats` as
/// FloatPlan::first().
[[nodiscard]] std::vector<double> measureWater(const WaterPlan& plan, std::span<const glm::vec4> cells,
                                               std::span<const glm::vec4> floats = {});

/// Returns the quantities of floating bodies only: "displaced" and the ones after it.
[[nodiscard]] std::vector<double> measureFloats(const WaterPlan& plan, std::span<const glm::vec4> floats);

/// Returns the factors that turn the sums over cells of depth, h |u|^2 / 2, h (level + bed) / 2 and wet
/// cells into volume, kinetic energy, potential energy and wet area.
[[nodiscard]] glm::vec4 waterSumFactors(const WaterParameters& parameters);

}  // namespace simreel::sim
