// Cells of a corridor, a straight line between two cells with the width `width`, connected over edges, not only over
// corners. For each step along the longer axis, it covers a range of cells of the shorter axis. Compiles as GLSL and as
// C++, after common/exact.glsl.

// Range of cells of the shorter axis in one step, relative to the corridor's start.
struct CorridorCells {
  int first, last;
};

// Returns the range in step `along` of `longer`, while the shorter axis advances by `shorter`, 0 to `longer`. A line of
// slope s = shorter/longer cuts `width` sqrt(1 + s^2) cells of a column.
FUNCTION CorridorCells corridorCells(int along, int longer, int shorter, int width) {
  precise float slope = float(shorter) * exactReciprocal(float(max(longer, 1)));
  precise float stretched = slope * slope + 1.0f;
  precise float cut = exactSqrt(stretched) * float(width) - 0.001f;
  int thick = int(floor(cut)) + 1;
  int doubled = 2 * max(longer, 1);
  int here = (2 * min(along, longer) * shorter + longer) / doubled;
  int before = along == 0 ? here : (2 * (along - 1) * shorter + longer) / doubled;
  CorridorCells c;
  // Includes the row of the previous step, so that a corridor of one cell stays connected over edges at a bend.
  c.first = min(before, here - (thick - 1) / 2);
  c.last = here + thick / 2;
  return c;
}
