#pragma once
#include "sim/automata/rule/cell_rule.hpp"

#include <string>

namespace simreel::sim {

/// Returns the GLSL body of nextCells (glsl/life/formula_model.glsl) for a rule on bits: statements of
/// which the last is a return. Builds a reduced ordered binary decision diagram (Bryant 1986) over the nine
/// cells; each node selects between two words. Tries several variable orders and uses the one with the
/// fewest nodes. The result is the same on every machine.
[[nodiscard]] std::string bitFormula(const CellRule& rule);

}  // namespace simreel::sim
