#pragma once
#include "sim/contact/plan.hpp"

#include <span>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Returns the number of intersections between an edge and a face that have no corner in common, computed
/// in float64. Intersections between solids are not counted. `positions` holds all parts of the plan, one
/// after another.
[[nodiscard]] long crossingsOf(const ContactPlan& plan, std::span<const glm::vec4> positions);

}  // namespace simreel::sim
