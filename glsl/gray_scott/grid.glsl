// How the cells lie in memory: rows of `columns` elements, each two cells (u, v, u, v), x fastest. In rows of
// odd width (ODD_WIDTH) the last element's second half is cell 0 of the row again, computed from the same
// numbers, so the torus closes without a case of its own in the arithmetic.
#include "common/bindings.glsl"
#include "common/memory.glsl"
#include "gray_scott/bindings.glsl"
#include "gray_scott/model.glsl"

INPUT_ARRAY(cellsBinding, CellBlock, cells)
uniform ivec2 size;      // cells
uniform int columns;     // elements of a row
uniform ivec2 rowRange;  // first row of this pass, and how many; they may go over the border
layout(std140, binding = stepBinding) uniform RatesBlock { GrayScottRates rates; };

#ifdef MAPPED
INPUT_ARRAY(weightsBinding, WeightBlock, weights)
#endif

// Rows beyond the border come back on the other side, up to twice the size; further out any will do.
int wrappedRow(int y) {
  return y < 0 ? y + size.y : y >= size.y ? min(y - size.y, size.y - 1) : y;
}

// Element x of a row, -1 <= x <= columns; at and beyond the border what follows on the torus.
vec4 cellPair(int x, int row) {
  int inside = x < 0 ? columns - 1 : x >= columns ? 0 : x;
  vec4 pair = LOAD_INPUT(cells, row * columns + inside);
#ifdef ODD_WIDTH
  if (x < 0) pair = pair.xyxy;
  if (x >= columns) pair = pair.zwzw;
#endif
  return pair;
}

// Sums of left and right neighbour of the two cells of an element.
vec4 sideSums(vec4 left, vec4 here, vec4 right) {
  precise vec4 sums = vec4(left.zw, here.xy) + vec4(here.zw, right.xy);
  return sums;
}

// The rates of the two cells of an element as (feed, kill, feed, kill).
vec4 ratesAt(int element) {
#ifdef MAPPED
  vec4 w = LOAD_INPUT(weights, element);
  return vec4(mappedRate(rates.feed, rates.feedSpan, w.x), mappedRate(rates.kill, rates.killSpan, w.y),
              mappedRate(rates.feed, rates.feedSpan, w.z), mappedRate(rates.kill, rates.killSpan, w.w));
#else
  return vec2(rates.feed, rates.kill).xyxy;
#endif
}

GrayScottRates cellRates(vec2 feedKill) {
  GrayScottRates cell = rates;
  cell.feed = feedKill.x;
  cell.kill = feedKill.y;
  return cell;
}

// The two cells of an element one step later: `edges` and `corners` are sums of four neighbours, componentwise.
vec4 steppedPair(vec4 here, vec4 edges, vec4 corners, vec4 local) {
  GrayScottRates a = cellRates(local.xy), b = cellRates(local.zw);
  float reactedA = reaction(here.x, here.y, rates.dt);
  float reactedB = reaction(here.z, here.w, rates.dt);
  return vec4(nextU(here.x, laplacian20(here.x, edges.x, corners.x), reactedA, a),
              nextV(here.y, laplacian20(here.y, edges.y, corners.y), reactedA, a),
              nextU(here.z, laplacian20(here.z, edges.z, corners.z), reactedB, b),
              nextV(here.w, laplacian20(here.w, edges.w, corners.w), reactedB, b));
}
