#pragma once
#include "sim/automata/rule/cell_rule.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace simreel::sim {

/// Parsers of the notations that parseCellRule() distinguishes; they modify `rule` only on success.
[[nodiscard]] RuleProblem parseCounts(std::string_view text, CellRule& rule);
[[nodiscard]] RuleProblem parseMap(std::string_view text, CellRule& rule);
[[nodiscard]] RuleProblem parseWolfram(std::string_view text, CellRule& rule);
[[nodiscard]] RuleProblem parseWide(std::string_view text, CellRule& rule);
[[nodiscard]] RuleProblem parseCyclic(std::string_view text, CellRule& rule);

/// Returns the counted cells of a Larger than Life shape that cannot be expressed by row spans: 'X', '*',
/// '#', 'B', 'D', 'A', '3', 'L' (its rows reach to `range`, its columns twice as far) and 'G' (whose centre
/// weighs one more).
[[nodiscard]] std::vector<NeighbourPlace> placesOfShape(char letter, int range);

/// Returns a character as shown in messages.
[[nodiscard]] std::string shownCharacter(std::string_view text, std::size_t at);

/// Reads digits at `at` as a number from `min` to `max`; `what` names it in messages.
[[nodiscard]] RuleProblem takeRuleNumber(std::string_view text, std::size_t& at, const char* what, int min,
                                         int max, int& value);

}  // namespace simreel::sim
