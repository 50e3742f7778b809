#pragma once
#include "sim/water/plan.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Returns the minimum height (metres) of the drawn walls at the grid's sides, slightly above the water.
[[nodiscard]] float groundRim(const WaterPlan& plan);

/// Returns for each cell an index into groundPalette() as a half float, padded to whole 32-bit words.
[[nodiscard]] std::vector<std::uint16_t> groundColors(const WaterPlan& plan);

/// Returns linear RGB shades of the ground's colour: lighter and darker patches, each in several degrees of
/// wetness (wetter ground is darker).
[[nodiscard]] std::vector<glm::vec4> groundPalette(const WaterPlan& plan);

}  // namespace simreel::sim
