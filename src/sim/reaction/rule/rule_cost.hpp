#pragma once
#include "sim/reaction/rule/rule.hpp"

namespace simreel::sim {

/// What the rates and nexts of a rule cost in a step with Euler's method, in additions or multiplications a
/// cell.
[[nodiscard]] int costOfRule(const Rule& rule);

}  // namespace simreel::sim
