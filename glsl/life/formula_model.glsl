// Any rule of nine cells on bits, as model.glsl has those that count. FORMULA is the body of nextCells for the rule: choices
// between words, generated (src/sim/automata/engine/bit_formula.hpp).

// A row's cells as each of its cells sees them.
struct RowSum {
  WORD west;
  WORD here;
  WORD east;
};

FUNCTION RowSum rowSum(WORD west, WORD here, WORD east) {
  RowSum row;
  row.west = west;
  row.here = here;
  row.east = east;
  return row;
}

FUNCTION WORD choose(WORD bit, WORD ifZero, WORD ifOne) {
  return (ifZero & ~bit) | (ifOne & bit);
}

FUNCTION WORD nextCells(RowSum above, RowSum here, RowSum below, WORD alive) {
  FORMULA
}
