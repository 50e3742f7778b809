// Variant of project.comp for open tiles. It works in place, because an invocation reads no flow of other cells. The
// temperature does not change.
#define FLOW_IN_PLACE
#define READS_SUM
#define READS_KEPT
#include "fluid/grid.glsl"
#include "fluid/tiles.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
uniform int tilesStart;  // Index of the tile list's first element

void slow(int i, vec2 from, vec2 to) {
  precise float value = flow[i] - rise(from, to, false);
  flow[i] = exactFlush(value);
}

void press(int i, vec2 sum) {
  precise float pressure = keptOf(flow[3 * planeSize() + i]) + stepData.perDt * (sum.x + sum.y);
  flow[3 * planeSize() + i] = exactFlush(pressure);
}

void main() {
  ivec2 block = blockHere(tilesStart);
  if (2 * block.x >= size.x) return;
  int row = size.x + 2, e = elementOf(2 * block.x, 2 * block.y), f = e + row, v = planeSize();
  int blockRow = size.x / 2 + 1, at = block.y * blockRow + block.x, lostAt = blockRow * (size.y / 2 + 1) + at;
  vec4 sum = LOAD_INPUT(pool, at), lost = LOAD_INPUT(pool, lostAt);
  vec4 sumLeft = LOAD_INPUT(pool, at - 1), lostLeft = LOAD_INPUT(pool, lostAt - 1);
  vec4 sumTop = LOAD_INPUT(pool, at - blockRow), lostTop = LOAD_INPUT(pool, lostAt - blockRow);
  vec2 s00 = vec2(sum.x, lost.x), s10 = vec2(sum.y, lost.y), s01 = vec2(sum.z, lost.z), s11 = vec2(sum.w, lost.w);
  slow(e, vec2(sumLeft.y, lostLeft.y), s00);
  slow(e + 1, s00, s10);
  slow(f, vec2(sumLeft.w, lostLeft.w), s01);
  slow(f + 1, s01, s11);
  slow(v + e, vec2(sumTop.z, lostTop.z), s00);
  slow(v + e + 1, vec2(sumTop.w, lostTop.w), s10);
  slow(v + f, s00, s01);
  slow(v + f + 1, s10, s11);
  press(e, s00);
  press(e + 1, s10);
  press(f, s01);
  press(f + 1, s11);
}
