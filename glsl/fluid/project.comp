// Subtracts the gradient of the pressure correction from the flow, extends the flow into obstacles and the ring, and
// measures the result. On the storage path, it processes only the ring and the tiles that are not open, and writes to
// the solver's buffer; project_open.comp, settle.comp and check.comp do the remaining work.
#define READS_SUM
#define READS_KEPT
#include "fluid/grid.glsl"
#include "common/status.glsl"
#include "fluid/solver/solve_control.glsl"
#include "fluid/cells.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
#ifdef TEXEL_PATH
STATE_ARRAY(nextFlowBinding, NextBlock, nextFlow)
uniform uint number;      // Step number for the status buffer
uniform float lostSpeed;  // Speed in cells/s above which the flow counts as lost

float speedOf(vec4 cell) {
  return max(abs(cell.x), abs(cell.y));
}

void noteCell(int x, int y, vec4 cell) {
  if (speedOf(cell) > lostSpeed || !isNumber(cell.x) || !isNumber(cell.y) || !isNumber(cell.z))
    noteLost(number, uint(y * size.x + x));
}
#endif

#if IN_THE_OPEN == 1
float slowed(float speed, vec2 from, vec2 to) {
  precise float value = speed - rise(from, to, false);
  return exactFlush(value);
}

float missingBetween(int x, int y, float left, float right, float top, float bottom) {
  precise float out_ = (right - left) + (bottom - top);
  precise float missing = growthAt(x, y) - out_;
  return abs(missing);
}

vec4 finishedOf(vec4 cell, float u, float v, vec2 sum) {
  precise float pressure = cell.w + stepData.perDt * (sum.x + sum.y);
  return vec4(u, v, exactFlush(cell.z), exactFlush(pressure));
}

// Projects a block of 2x2 cells. Returns the remaining divergence and the maximum speed.
vec2 projected(ivec2 block) {
  int x = 2 * block.x, y = 2 * block.y, row = size.x + 2, e = elementOf(x, y), f = e + row;
  int blockRow = size.x / 2 + 1, at = block.y * blockRow + block.x, lostAt = blockRow * (size.y / 2 + 1) + at;
  vec4 sum = LOAD_INPUT(pool, at), lost = LOAD_INPUT(pool, lostAt);
  vec4 sumLeft = LOAD_INPUT(pool, at - 1), lostLeft = LOAD_INPUT(pool, lostAt - 1);
  vec4 sumRight = LOAD_INPUT(pool, at + 1), lostRight = LOAD_INPUT(pool, lostAt + 1);
  vec4 sumTop = LOAD_INPUT(pool, at - blockRow), lostTop = LOAD_INPUT(pool, lostAt - blockRow);
  vec4 sumBottom = LOAD_INPUT(pool, at + blockRow), lostBottom = LOAD_INPUT(pool, lostAt + blockRow);
  vec2 s00 = vec2(sum.x, lost.x), s10 = vec2(sum.y, lost.y), s01 = vec2(sum.z, lost.z), s11 = vec2(sum.w, lost.w);
  vec4 here = LOAD_INPUT(flow, e), right = LOAD_INPUT(flow, e + 1), below = LOAD_INPUT(flow, f);
  vec4 corner = LOAD_INPUT(flow, f + 1);
  float u00 = slowed(here.x, vec2(sumLeft.y, lostLeft.y), s00), u10 = slowed(right.x, s00, s10);
  float u20 = slowed(LOAD_INPUT(flow, e + 2).x, s10, vec2(sumRight.x, lostRight.x));
  float u01 = slowed(below.x, vec2(sumLeft.w, lostLeft.w), s01), u11 = slowed(corner.x, s01, s11);
  float u21 = slowed(LOAD_INPUT(flow, f + 2).x, s11, vec2(sumRight.z, lostRight.z));
  float v00 = slowed(here.y, vec2(sumTop.z, lostTop.z), s00), v10 = slowed(right.y, vec2(sumTop.w, lostTop.w), s10);
  float v01 = slowed(below.y, s00, s01), v11 = slowed(corner.y, s10, s11);
  float v02 = slowed(LOAD_INPUT(flow, f + row).y, s01, vec2(sumBottom.x, lostBottom.x));
  float v12 = slowed(LOAD_INPUT(flow, f + row + 1).y, s11, vec2(sumBottom.y, lostBottom.y));
  here = finishedOf(here, u00, v00, s00);
  right = finishedOf(right, u10, v10, s10);
  below = finishedOf(below, u01, v01, s01);
  corner = finishedOf(corner, u11, v11, s11);
  STORE_STATE(nextFlow, e, here);
  STORE_STATE(nextFlow, e + 1, right);
  STORE_STATE(nextFlow, f, below);
  STORE_STATE(nextFlow, f + 1, corner);
  float missing = max(max(missingBetween(x, y, u00, u10, v00, v01), missingBetween(x + 1, y, u10, u20, v10, v11)),
                      max(missingBetween(x, y + 1, u01, u11, v01, v02), missingBetween(x + 1, y + 1, u11, u21, v11, v12)));
  float speed = max(max(speedOf(here), speedOf(right)), max(speedOf(below), speedOf(corner)));
  noteCell(x, y, here);
  noteCell(x + 1, y, right);
  noteCell(x, y + 1, below);
  noteCell(x + 1, y + 1, corner);
  return vec2(missing, speed);
}

void main() {
  ivec2 block = blockHere(tilesStart);
  vec2 maximum = vec2(0.0);
  if (2 * block.x < size.x) maximum = projected(block);
  noteMaximum(maximum.x, maximum.y, maximum.y);
}
#elif defined TEXEL_PATH
void main() {
  float missing = 0.0, speed = 0.0;
  for (int k = 0; k < cellsEach; ++k) {
    ivec2 c = cellHere(k);
    if (c.x > size.x || c.y > size.y) continue;
    vec4 cell = finishedCell(c.x, c.y);
    STORE_STATE(nextFlow, elementOf(c.x, c.y), cell);
    if (tilesStart < 0) continue;
    missing = max(missing, abs(stillMissing(c.x, c.y)));
    speed = max(speed, speedOf(cell));
    noteCell(c.x, c.y, cell);
  }
  noteMaximum(missing, speed, speed);
}
#else
#include "fluid/settling.glsl"

void main() {
  ivec2 c = cellHere(0);
  if (c.x <= size.x && c.y <= size.y) settleLater(elementOf(c.x, c.y), finishedCell(c.x, c.y));
}
#endif
