// Any rule on nine cells, computed on bits like the counting rules of model.glsl. FORMULA is the generated body of
// nextCells(), which consists of bitwise selections (src/sim/automata/engine/bit_formula.hpp).

// Cells of a row, shifted so that at each bit position there are the west neighbour, the cell itself and the east
// neighbour.
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
