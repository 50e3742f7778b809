#pragma once
#include "sim/water/plan.hpp"

#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// The vertices of what is drawn under the water, a cell each: place (m), and in w the number of a colour
/// of groundPalette. Walls at sides stand up a little beyond the water.
[[nodiscard]] std::vector<glm::vec4> groundVertices(const WaterPlan& plan);

/// Linear RGB: the ground's colour, lighter and darker in patches, and darker where the first state's water
/// wets it.
[[nodiscard]] std::vector<glm::vec4> groundPalette(const WaterPlan& plan);

}  // namespace simreel::sim
