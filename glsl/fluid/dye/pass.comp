// Computes one pass of dye transport in flux form: dye that leaves a cell through a face enters the neighbour.
#define READS_DYE
#define NEXT_DYE
#include "fluid/grid.glsl"
#include "fluid/cells.glsl"
layout(local_size_x = 8, local_size_y = 8) in;

#if IN_THE_OPEN == 1
vec4 dyeThere(int element) {
  return LOAD_INPUT(dye, element);
}

vec4 dyedBetween(vec4 here, vec4 left, vec4 right, vec4 top, vec4 bottom) {
  precise vec4 next = here - ((right - left) + (bottom - top));
  return next;
}

// Processes a block of 2x2 cells whose faces are all open, computing each flux only once.
void main() {
  ivec2 block = blockHere(tilesStart);
  if (2 * block.x >= size.x) return;
  int row = size.x + 2, e = elementOf(2 * block.x, 2 * block.y), f = e + row;
  vec4 here = dyeThere(e), right = dyeThere(e + 1), below = dyeThere(f), corner = dyeThere(f + 1);
  vec4 flowHere = LOAD_INPUT(flow, e), flowRight = LOAD_INPUT(flow, e + 1);
  vec4 flowBelow = LOAD_INPUT(flow, f), flowCorner = LOAD_INPUT(flow, f + 1);
  vec4 a = dyeThere(e - 1), b = dyeThere(e + 2);
  vec4 left = dyeFluxes(dyeWay(flowHere.x), dyeThere(e - 2), a, here, right);
  vec4 middle = dyeFluxes(dyeWay(flowRight.x), a, here, right, b);
  vec4 end = dyeFluxes(dyeWay(LOAD_INPUT(flow, e + 2).x), here, right, b, dyeThere(e + 3));
  vec4 c = dyeThere(f - 1), d = dyeThere(f + 2);
  vec4 leftBelow = dyeFluxes(dyeWay(flowBelow.x), dyeThere(f - 2), c, below, corner);
  vec4 middleBelow = dyeFluxes(dyeWay(flowCorner.x), c, below, corner, d);
  vec4 endBelow = dyeFluxes(dyeWay(LOAD_INPUT(flow, f + 2).x), below, corner, d, dyeThere(f + 3));
  a = dyeThere(e - row);
  b = dyeThere(f + row);
  vec4 top = dyeFluxes(dyeWay(flowHere.y), dyeThere(e - 2 * row), a, here, below);
  vec4 across = dyeFluxes(dyeWay(flowBelow.y), a, here, below, b);
  vec4 bottom = dyeFluxes(dyeWay(LOAD_INPUT(flow, f + row).y), here, below, b, dyeThere(f + 2 * row));
  c = dyeThere(e - row + 1);
  d = dyeThere(f + row + 1);
  vec4 topRight = dyeFluxes(dyeWay(flowRight.y), dyeThere(e - 2 * row + 1), c, right, corner);
  vec4 acrossRight = dyeFluxes(dyeWay(flowCorner.y), c, right, corner, d);
  vec4 bottomRight = dyeFluxes(dyeWay(LOAD_INPUT(flow, f + row + 1).y), right, corner, d, dyeThere(f + 2 * row + 1));
  storeDye(e, dyedBetween(here, left, middle, top, across));
  storeDye(e + 1, dyedBetween(right, middle, end, topRight, acrossRight));
  storeDye(f, dyedBetween(below, leftBelow, middleBelow, across, bottom));
  storeDye(f + 1, dyedBetween(corner, middleBelow, endBelow, acrossRight, bottomRight));
}
#else
void main() {
  for (int k = 0; k < cellsEach; ++k) {
    ivec2 c = cellHere(k);
    if (c.x <= size.x && c.y <= size.y) storeDye(elementOf(c.x, c.y), dyedCell(c.x, c.y));
  }
}
#endif
