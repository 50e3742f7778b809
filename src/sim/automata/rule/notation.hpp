#pragma once
#include "sim/automata/rule/cell_rule.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace simreel::sim {

/// Readers of the notations that parseCellRule tells apart; each sets `rule` only where nothing is wrong.
[[nodiscard]] RuleProblem parseCounts(std::string_view text, CellRule& rule);
[[nodiscard]] RuleProblem parseMap(std::string_view text, CellRule& rule);
[[nodiscard]] RuleProblem parseWolfram(std::string_view text, CellRule& rule);
[[nodiscard]] RuleProblem parseWide(std::string_view text, CellRule& rule);
[[nodiscard]] RuleProblem parseCyclic(std::string_view text, CellRule& rule);

/// The cells around one that count in a shape of Larger than Life that is no row of spans: 'X', '*', '#',
/// 'B', 'D', 'A', '3', 'L' (its rows reach to `range`, columns twice as far) and 'G' (whose middle counts
/// once more).
[[nodiscard]] std::vector<NeighbourPlace> placesOfShape(char letter, int range);

/// A character as messages show it.
[[nodiscard]] std::string shownCharacter(std::string_view text, std::size_t at);

/// Reads the digits at `at` as a number of at most `max`; `what` names it in messages.
[[nodiscard]] RuleProblem takeRuleNumber(std::string_view text, std::size_t& at, const char* what, int min,
                                         int max, int& value);

}  // namespace simreel::sim
