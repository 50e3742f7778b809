#pragma once
#include "sim/automata/cell_rule.hpp"

#include <string_view>

namespace simreel::sim {

/// Readers of the notations that parseCellRule tells apart; each sets `rule` only where nothing is wrong.
[[nodiscard]] RuleProblem parseCounts(std::string_view text, CellRule& rule);
[[nodiscard]] RuleProblem parseMap(std::string_view text, CellRule& rule);
[[nodiscard]] RuleProblem parseWide(std::string_view text, CellRule& rule);
[[nodiscard]] RuleProblem parseCyclic(std::string_view text, CellRule& rule);

/// A character as messages show it.
[[nodiscard]] std::string shownCharacter(std::string_view text, std::size_t at);

/// Reads the digits at `at` as a number of at most `max`; `what` names it in messages.
[[nodiscard]] RuleProblem takeRuleNumber(std::string_view text, std::size_t& at, const char* what, int min,
                                         int max, int& value);

}  // namespace simreel::sim
