// Memory layout of the cells: rows of `columns` elements with two cells per element (u, v, u, v), x fastest. If the
// width is odd (ODD_WIDTH), the second half of a row's last element is a copy of cell 0, computed from the same
// numbers, so that the torus needs no special case in the arithmetic.
#include "common/bindings.glsl"
#include "common/memory.glsl"
#include "gray_scott/bindings.glsl"
#include "gray_scott/model.glsl"

INPUT_ARRAY(cellsBinding, CellBlock, cells)
uniform ivec2 size;      // Size of the grid in cells
uniform int columns;     // Number of elements per row
uniform ivec2 rowRange;  // First row and number of rows of this pass; rows may be beyond the border
layout(std140, binding = stepBinding) uniform RatesBlock { GrayScottRates rates; };

#ifdef MAPPED
INPUT_ARRAY(weightsBinding, WeightBlock, weights)
#endif

// Wraps a row index that is beyond the border by up to the height. The result for other indices is arbitrary.
int wrappedRow(int y) {
  return y < 0 ? y + size.y : y >= size.y ? min(y - size.y, size.y - 1) : y;
}

// Returns element x of a row, for -1 <= x <= columns. Beyond the border, it returns the wrapped cells of the torus.
vec4 cellPair(int x, int row) {
  int inside = x < 0 ? columns - 1 : x >= columns ? 0 : x;
  vec4 pair = LOAD_INPUT(cells, row * columns + inside);
#ifdef ODD_WIDTH
  if (x < 0) pair = pair.xyxy;
  if (x >= columns) pair = pair.zwzw;
#endif
  return pair;
}

// Returns the sum of the left and the right neighbour, for both cells of an element.
vec4 sideSums(vec4 left, vec4 here, vec4 right) {
  precise vec4 sums = vec4(left.zw, here.xy) + vec4(here.zw, right.xy);
  return sums;
}

// Returns the rates of the two cells of an element: (feed, kill, feed, kill).
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

// Returns the two cells of an element one step later. `edges` and `corners` are the sums of the four neighbours of each
// kind, per component.
vec4 steppedPair(vec4 here, vec4 edges, vec4 corners, vec4 local) {
  GrayScottRates a = cellRates(local.xy), b = cellRates(local.zw);
  float reactedA = reaction(here.x, here.y, rates.dt);
  float reactedB = reaction(here.z, here.w, rates.dt);
  return vec4(nextU(here.x, laplacian20(here.x, edges.x, corners.x), reactedA, a),
              nextV(here.y, laplacian20(here.y, edges.y, corners.y), reactedA, a),
              nextU(here.z, laplacian20(here.z, edges.z, corners.z), reactedB, b),
              nextV(here.w, laplacian20(here.w, edges.w, corners.w), reactedB, b));
}
