// Outer-totalistic automata on bits: a WORD holds one cell per bit, and bitwise logic counts the neighbours of all
// cells in parallel. Compiles as GLSL and as C++ (tests/reference/life_twin.cpp). The rule is given by BORN and
// SURVIVE, whose bit n stands for n live neighbours.

// Sum of west, here and east for every cell, as two bits: low + 2 high.
struct RowSum {
  WORD low;
  WORD high;
};

// Full adder: low = a xor b xor c, high = majority.
FUNCTION RowSum rowSum(WORD west, WORD here, WORD east) {
  WORD either = west ^ here;
  RowSum sum;
  sum.low = either ^ east;
  sum.high = (west & here) | (either & east);
  return sum;
}

FUNCTION WORD choose(WORD bit, WORD ifZero, WORD ifOne) {
  return (ifZero & ~bit) | (ifOne & bit);
}

// Returns the next state of cells for which the cell and its neighbours together have `total` live cells. If the cell
// is alive, it therefore has total - 1 live neighbours. Total 0 with a live cell, and total 9 with a dead cell, cannot
// occur; for them, the simpler result is returned.
FUNCTION WORD outcome(int total, WORD alive) {
  int born = BORN >> (total < 9 ? total : 8) & 1;
  int survives = SURVIVE >> (total > 0 ? total - 1 : 0) & 1;
  if (total == 0) survives = born;
  if (total == 9) born = survives;
  if (born == survives) return WORD(0u) - WORD(uint(born));
  return survives == 1 ? alive : ~alive;
}

// Returns true if the totals 8 and 9 have the same outcome as 0 and 1, for live and for dead cells.
FUNCTION bool lastAsFirst() {
  int born0 = BORN & 1;
  int born1 = BORN >> 1 & 1;
  int survives8 = SURVIVE >> 8 & 1;
  return (BORN >> 8 & 1) == born0 && (SURVIVE >> 7 & 1) == born0 && survives8 == born1 && survives8 == (SURVIVE & 1);
}

// Returns the next generation from the sums of three rows. The sum of nine cells is n0 + 2 n1 + 4 n2 + 8 n3:
//   l + l' + l''       = n0 + 2 carry
//   h + h' + h'' + carry = n1 + 2 n2 + 4 n3
FUNCTION WORD nextCells(RowSum above, RowSum here, RowSum below, WORD alive) {
  RowSum lows = rowSum(above.low, here.low, below.low);
  RowSum highs = rowSum(above.high, here.high, below.high);
  WORD n0 = lows.low;
  WORD n1 = highs.low ^ lows.high;
  WORD carry = highs.low & lows.high;
  WORD n2 = highs.high ^ carry;
  WORD n3 = highs.high & carry;
  WORD upTo3 = choose(n1, choose(n0, outcome(0, alive), outcome(1, alive)),
                      choose(n0, outcome(2, alive), outcome(3, alive)));
  WORD upTo7 = choose(n1, choose(n0, outcome(4, alive), outcome(5, alive)),
                      choose(n0, outcome(6, alive), outcome(7, alive)));
  WORD next = choose(n2, upTo3, upTo7);
  if (lastAsFirst()) return next;  // Totals 8 and 9 have n1 = n2 = 0, like 0 and 1
  return choose(n3, next, choose(n0, outcome(8, alive), outcome(9, alive)));
}
