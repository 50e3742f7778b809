#pragma once
#include "sim/contact/plan.hpp"

#include <span>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Returns the number of intersections of an edge with a face that does not contain a corner of the edge,
/// computed in float64; intersections between solids are not counted. `positions`: all parts of the plan,
/// one after the other.
[[nodiscard]] long crossingsOf(const ContactPlan& plan, std::span<const glm::vec4> positions);

}  // namespace simreel::sim
