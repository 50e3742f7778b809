// Where a cell of one grid lies on another that covers the same. Compiles as GLSL and as C++ (src/sim/reaction/rule/model.hpp).

// Between the middles of two cells: the share of the second, a multiple of 2^-15.
struct Between {
  int before;
  int after;
  float share;
};

// The middle of cell i of `count` among `sources` along the same side: (i + 1/2) sources / count - 1/2, in whole parts of a
// half of 1 / count; beyond the middles of the outermost it is these. Grids of the same size meet exactly. Both up to 32,768.
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

// The same of a place in `mapParts` of the whole side, from 0 to mapParts - 1: at sources / mapParts - 1/2.
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
