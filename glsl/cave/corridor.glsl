// A corridor is a straight line of cells from one to another, `width` across, without corners that only touch: for each
// step along its longer axis some cells of the shorter one. Compiles as GLSL and as C++; common/exact.glsl comes before it.

// Of the shorter axis in a step: cells from `first` to `last`, relative to where the corridor begins.
struct CorridorCells {
  int first, last;
};

// `along` steps of `longer`, in which the shorter axis advances by `shorter`, 0 to `longer`. A line of slope
// s = shorter/longer is cut by `width` sqrt(1 + s^2) cells of a column.
FUNCTION CorridorCells corridorCells(int along, int longer, int shorter, int width) {
  precise float slope = float(shorter) * exactReciprocal(float(max(longer, 1)));
  precise float stretched = slope * slope + 1.0f;
  precise float cut = exactSqrt(stretched) * float(width) - 0.001f;
  int thick = int(floor(cut)) + 1;
  int doubled = 2 * max(longer, 1);
  int here = (2 * min(along, longer) * shorter + longer) / doubled;
  int before = along == 0 ? here : (2 * (along - 1) * shorter + longer) / doubled;
  CorridorCells c;
  // With the row of the step before, a corridor of one cell turns no corner without touching an edge.
  c.first = min(before, here - (thick - 1) / 2);
  c.last = here + thick / 2;
  return c;
}
