#pragma once
#include "sim/automata/rule/cell_rule.hpp"

#include <array>
#include <bitset>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace simreel::sim {

/// One transition of a rule table without variables: it applies where each input (the middle first, then
/// the neighbours as the table's neighbourhood lists them) is among the states given, and the first that
/// applies of a table counts.
struct RuleTransition {
  std::array<std::bitset<256>, 9> inputs;
  int output = 0;
};

/// Neighbourhoods of tables, with the orders of their neighbours:
/// vonNeumann N E S W; moore N NE E SE S SW W NW; hexagonal N E SE S W NW; oneDimensional W E.
enum class TableShape { vonNeumann, moore, hexagonal, oneDimensional };
[[nodiscard]] int neighboursOf(TableShape shape);

/// The diagram of a table of `states` states; what no transition applies to stays. Null where it would have
/// more items than maxTreeItems.
[[nodiscard]] std::shared_ptr<const RuleTree> treeOf(const std::vector<RuleTransition>& table,
                                                     TableShape shape, int states);
inline constexpr std::size_t maxTreeItems = std::size_t{1} << 21;

}  // namespace simreel::sim
