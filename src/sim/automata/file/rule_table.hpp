#pragma once
#include "sim/automata/file/rule_text.hpp"
#include "sim/automata/rule/cell_rule.hpp"

namespace simreel::sim {

/// Parses the section @TABLE as a rule without a name. Throws the UserError of readRuleFile().
[[nodiscard]] CellRule parseRuleTable(const RuleFileText& file);

}  // namespace simreel::sim
