// Cells of a corridor: a straight line between two cells with the width `width`, whose cells are connected over edges
// and not only over corners. For each step along the longer axis, the corridor covers a range of cells along the
// shorter axis. Compiles as GLSL and as C++, after common/exact.glsl.

// Range of cells along the shorter axis in one step, relative to the corridor's start.
struct CorridorCells {
  int first, last;
};

// Returns the range in step `along` of `longer` steps, while the position on the shorter axis advances from 0 to
// `shorter`, with 0 <= `shorter` <= `longer`. In a column, a line of slope s = shorter/longer covers `width` sqrt(1 +
// s^2) cells.
FUNCTION CorridorCells corridorCells(int along, int longer, int shorter, int width) {
  precise float slope = float(shorter) * exactReciprocal(float(max(longer, 1)));
  precise float stretched = slope * slope + 1.0f;
  precise float cut = exactSqrt(stretched) * float(width) - 0.001f;
  int thick = int(floor(cut)) + 1;
  int doubled = 2 * max(longer, 1);
  int here = (2 * min(along, longer) * shorter + longer) / doubled;
  int before = along == 0 ? here : (2 * (along - 1) * shorter + longer) / doubled;
  CorridorCells c;
  // Includes the row of the previous step, so that a corridor that is one cell wide stays connected over edges at a
  // bend.
  c.first = min(before, here - (thick - 1) / 2);
  c.last = here + thick / 2;
  return c;
}
