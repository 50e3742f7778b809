// Position of a cell of one grid on another grid of the same extent. Compiles as GLSL and as C++
// (src/sim/reaction/rule/model.hpp).

// Position between the centres of two cells. `share` is the weight of the second cell, a multiple of 2^-15.
struct Between {
  int before;
  int after;
  float share;
};

// Returns the position of the centre of cell i of `count` on a grid of `sources` cells with the same extent: (i + 1/2)
// sources / count - 1/2, computed in integers in units of 1 / (2 count). Positions beyond the outermost centres are
// clamped. Grids of the same size match exactly. Both counts may be up to 32,768.
FUNCTION Between betweenCells(int i, int count, int sources) {
  int at = max((2 * i + 1) * sources - count, 0);
  Between b;
  b.before = at / (2 * count);
  b.after = min(b.before + 1, sources - 1);
  int rest = at - b.before * 2 * count;
  precise float share = float(rest * 32768 / (2 * count)) * 3.0517578125e-5f;
  b.share = share;
  return b;
}

// Returns the position on a grid of `sources` cells for a coordinate `at` from 0 to mapParts - 1 along the extent: at
// sources / mapParts - 1/2.
const int mapParts = 65536;
FUNCTION Between betweenAt(int at, int sources) {
  int place = max(at * sources - mapParts / 2, 0);
  Between b;
  b.before = place / mapParts;
  b.after = min(b.before + 1, sources - 1);
  precise float share = float(place % mapParts) * 1.52587890625e-5f;
  b.share = share;
  return b;
}

FUNCTION float betweenOf(float a, float b, float share) {
  precise float difference = b - a;
  precise float part = difference * share;
  precise float sum = a + part;
  return sum;
}
