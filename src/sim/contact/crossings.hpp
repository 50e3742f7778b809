#pragma once
#include "sim/contact/plan.hpp"

#include <span>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Edges that go through faces of which they have no corner, counted once for each such face, in float64;
/// solids with solids do not count. `positions` of all parts of the plan, one part after the other.
[[nodiscard]] long crossingsOf(const ContactPlan& plan, std::span<const glm::vec4> positions);

}  // namespace simreel::sim
