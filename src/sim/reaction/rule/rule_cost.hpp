#pragma once
#include "sim/reaction/rule/rule.hpp"

namespace simreel::sim {

/// Returns the cost of a rule's rates and nexts in a step with Euler's method, in additions or
/// multiplications per cell.
[[nodiscard]] int costOfRule(const Rule& rule);

}  // namespace simreel::sim
