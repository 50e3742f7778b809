#pragma once
#include "sim/automata/rule/cell_rule.hpp"

#include <array>
#include <bitset>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace simreel::sim {

/// Transition of a rule table, with all variables expanded. It applies if the state of each input (the
/// centre first, then the neighbours in the table's order) is in the input's set of states. In a table, the
/// first transition that applies is used.
struct RuleTransition {
  std::array<std::bitset<256>, 9> inputs;
  int output = 0;
};

/// Neighbourhoods of tables. Their neighbours have this order: vonNeumann N E S W; moore N NE E SE S SW W
/// NW; hexagonal N E SE S W NW; oneDimensional W E.
enum class TableShape { vonNeumann, moore, hexagonal, oneDimensional };
[[nodiscard]] int neighboursOf(TableShape shape);

/// Returns the decision diagram of a table. Cells to which no transition applies keep their state. Returns
/// null if the diagram would have more than maxTreeItems items.
[[nodiscard]] std::shared_ptr<const RuleTree> treeOf(const std::vector<RuleTransition>& table,
                                                     TableShape shape, int states);
inline constexpr std::size_t maxTreeItems = std::size_t{1} << 21;

}  // namespace simreel::sim
