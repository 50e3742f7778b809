#pragma once
#include "sim/automata/cell_rule.hpp"
#include "sim/automata/rule_text.hpp"

namespace simreel::sim {

/// The section @TABLE as a rule without a name. Throws UserError as readRuleFile says.
[[nodiscard]] CellRule parseRuleTable(const RuleFileText& file);

}  // namespace simreel::sim
