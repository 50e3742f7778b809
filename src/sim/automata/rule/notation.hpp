#pragma once
#include "sim/automata/rule/cell_rule.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace simreel::sim {

/// Parsers for the notations that parseCellRule() distinguishes. They modify `rule` only if they succeed.
[[nodiscard]] RuleProblem parseCounts(std::string_view text, CellRule& rule);
[[nodiscard]] RuleProblem parseMap(std::string_view text, CellRule& rule);
[[nodiscard]] RuleProblem parseWolfram(std::string_view text, CellRule& rule);
[[nodiscard]] RuleProblem parseWide(std::string_view text, CellRule& rule);
[[nodiscard]] RuleProblem parseCyclic(std::string_view text, CellRule& rule);

/// Returns the counted cells of a Larger than Life shape that cannot be expressed by row spans: 'X', '*',
/// '#', 'B', 'D', 'A', '3', 'L' (whose rows extend to `range` and whose columns extend twice as far) and
/// 'G' (whose centre has a weight that is one larger).
[[nodiscard]] std::vector<NeighbourPlace> placesOfShape(char letter, int range);

/// Returns the character at an offset as it is shown in messages.
[[nodiscard]] std::string shownCharacter(std::string_view text, std::size_t at);

/// Reads digits at `at` as a number from `min` to `max`. `what` is the number's name in messages.
[[nodiscard]] RuleProblem takeRuleNumber(std::string_view text, std::size_t& at, const char* what, int min,
                                         int max, int& value);

}  // namespace simreel::sim
