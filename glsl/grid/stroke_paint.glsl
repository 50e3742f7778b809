// Part common to the paint kernels: one dispatch over the bounding box of one stroke. The including kernel first
// declares `stamps` with INPUT_WORDS, with a binding point that it chooses.
#include "common/hash.glsl"
#include "grid/stroke.glsl"
uniform Stroke stroke;
uniform ivec4 strokeBox;  // Bounding box of the stroke: first column, first row, number of columns, number of rows

// Computes the cell that this invocation processes. Returns false if it is outside the box.
bool strokeCell(uvec2 invocation, out ivec2 cell) {
  cell = strokeBox.xy + ivec2(invocation);
  return all(lessThan(ivec2(invocation), strokeBox.zw));
}

bool strokePaints(ivec2 cell) {
  if (!strokePicks(stroke, cell)) return false;
  if (stroke.imageSize.x == 0) return strokeReaches(stroke, cell);
  ivec2 at = cell - stroke.imageFrom;
  if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, stroke.imageSize))) return false;
  int bit = at.y * stroke.imageSize.x + at.x;
  int word = stroke.imageWord + (bit >> 5);
  uvec4 words = LOAD_INPUT_WORDS(stamps, word >> 2);
  return (words[word & 3] >> uint(bit & 31) & 1u) != 0u;
}
