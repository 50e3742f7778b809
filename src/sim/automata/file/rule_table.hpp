#pragma once
#include "sim/automata/file/rule_text.hpp"
#include "sim/automata/rule/cell_rule.hpp"

namespace simreel::sim {

/// The section @TABLE as a rule without a name. Throws UserError as readRuleFile says.
[[nodiscard]] CellRule parseRuleTable(const RuleFileText& file);

}  // namespace simreel::sim
