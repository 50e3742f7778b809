#pragma once
#include "sim/water/plan.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// The height (m) up to which walls at sides stand at least, a little beyond the water.
[[nodiscard]] float groundRim(const WaterPlan& plan);

/// Numbers of groundPalette as half floats, a cell each, filled up to whole words.
[[nodiscard]] std::vector<std::uint16_t> groundColors(const WaterPlan& plan);

/// Linear RGB: the ground's colour, lighter and darker in patches, and darker where the first state's water
/// wets it.
[[nodiscard]] std::vector<glm::vec4> groundPalette(const WaterPlan& plan);

}  // namespace simreel::sim
