#pragma once
#include "sim/reaction/text/kernel_text.hpp"

#include <functional>
#include <string>

namespace simreel::sim {

/// Returns one or two lines of GLSL that compute node `i` for four cells into the variable v<i>. `value`
/// returns the expression of an argument; `row` is the name of the variable with the row's index.
[[nodiscard]] std::string nodeText(const RuleGraph& graph, int i,
                                   const std::function<std::string(int node)>& value, unsigned seed,
                                   const char* row);

/// Returns the declarations of the uniform values of a pass: k<node> for each, the grains, and the values
/// beyond edges of the kind "fixed".
[[nodiscard]] std::string uniformText(const RulePass& pass, RuleBoundary boundary);

}  // namespace simreel::sim
