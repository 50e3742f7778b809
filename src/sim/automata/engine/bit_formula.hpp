#pragma once
#include "sim/automata/rule/cell_rule.hpp"

#include <string>

namespace simreel::sim {

/// The body of nextCells in glsl/life/formula_model.glsl for a rule on bits: statements that end in a
/// return. A reduced ordered decision diagram (Bryant 1986) over the nine cells, each node a choice between
/// two words; of several orders the one with the fewest nodes, the same on every machine.
[[nodiscard]] std::string bitFormula(const CellRule& rule);

}  // namespace simreel::sim
