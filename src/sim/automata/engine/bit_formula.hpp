#pragma once
#include "sim/automata/rule/cell_rule.hpp"

#include <string>

namespace simreel::sim {

/// Returns the GLSL body of nextCells (glsl/life/formula_model.glsl) for a rule whose cells are bits. The
/// body ends with a return statement. It is built as a reduced ordered binary decision diagram (Bryant
/// 1986) over the nine cells; each node selects between two words. Of several variable orders, the one with
/// the fewest nodes is used. The result is the same on every machine.
[[nodiscard]] std::string bitFormula(const CellRule& rule);

}  // namespace simreel::sim
