#pragma once
#include "sim/reaction/text/kernel_text.hpp"

#include <functional>
#include <string>

namespace simreel::sim {

/// A line or two of GLSL that compute node `i` of four cells, as v<i>. `value`: what its arguments are
/// called; `row`: the number of the cells' row in its plane.
[[nodiscard]] std::string nodeText(const RuleGraph& graph, int i,
                                   const std::function<std::string(int node)>& value, unsigned seed,
                                   const char* row);

/// Declares what a pass is told: k<node> of each, the grains, and values beyond fixed edges.
[[nodiscard]] std::string toldText(const RulePass& pass, RuleBoundary boundary);

}  // namespace simreel::sim
