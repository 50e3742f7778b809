// Computes one step of the water. An invocation processes a column of ROWS cells from top to bottom. The half steps and
// fluxes of the previous row stay in registers, so a cell needs three fluxes instead of the four of waterStepped(). The
// arithmetic operations have the same order.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/status.glsl"
#include "water/bindings.glsl"
#include "water/types.glsl"
layout(local_size_x = 32, local_size_y = 2) in;
INPUT_ARRAY(cellsBinding, CellBlock, cells)
STATE_ARRAY(nextCellsBinding, NextBlock, nextCells)
layout(std140, binding = stepBinding) uniform WaterBlock { WaterStep water; };
uniform ivec2 size;
uniform int stepNumber;  // Step of the frame, counted from 1

vec4 loadWater(int i) {
  return LOAD_INPUT(cells, i);
}
#include "water/model.glsl"
#include "water/step.glsl"

// Three adjacent cells of a row.
struct WaterRow {
  WaterCell w;
  WaterCell c;
  WaterCell e;
};

WaterRow rowAt(int x, int y, WaterStep uniforms, ivec2 grid) {
  return WaterRow(waterAt(x - 1, y, uniforms, grid), waterAt(x, y, uniforms, grid), waterAt(x + 1, y, uniforms, grid));
}

void main() {
  int x = int(gl_GlobalInvocationID.x);
  int top = int(gl_GlobalInvocationID.y) * ROWS;
  ivec2 grid = size;
  if (x >= grid.x || top >= grid.y) return;
  WaterStep uniforms = water;
  float g = uniforms.gravity, dry = uniforms.dry, k = uniforms.halfRatio;
  WaterRow above = rowAt(x, top - 1, uniforms, grid), here = rowAt(x, top, uniforms, grid), below = rowAt(x, top + 1, uniforms, grid);
  // The cell above half a step later, and the flux from that cell to this one.
  WaterCell before = waterAt(x, top - 2, uniforms, grid);
  WaterCell ax = waterSlope(above.w, above.c, above.e, dry);
  WaterCell ay = waterSlope(before, above.c, here.c, dry);
  WaterCell cx = waterSlope(here.w, here.c, here.e, dry);
  WaterCell cy = waterSlope(above.c, here.c, below.c, dry);
  WaterCell a2 = waterHalf(above.c, ax, ay, k, g);
  WaterCell c2 = waterHalf(here.c, cx, cy, k, g);
  precise float maxA = above.c.depth * uniforms.share;
  precise float maximum = here.c.depth * uniforms.share;
  WaterFlux north = waterFlux(waterSideY(above.c, a2, ay, 0.5f), waterSideY(here.c, c2, cy, -0.5f), g, maxA, maximum);
  float fastest = 0.0f;
  for (int j = 0; j < ROWS && top + j < grid.y; ++j) {
    int y = top + j;
    int i = y * grid.x + x;
    WaterRow next = rowAt(x, y + 2, uniforms, grid);
    WaterCell ex = waterSlope(here.c, here.e, waterAt(x + 2, y, uniforms, grid), dry);
    WaterCell ey = waterSlope(above.e, here.e, below.e, dry);
    WaterCell wx = waterSlope(waterAt(x - 2, y, uniforms, grid), here.w, here.c, dry);
    WaterCell wy = waterSlope(above.w, here.w, below.w, dry);
    WaterCell sx = waterSlope(below.w, below.c, below.e, dry);
    WaterCell sy = waterSlope(here.c, below.c, next.c, dry);
    WaterCell e2 = waterHalf(here.e, ex, ey, k, g);
    WaterCell w2 = waterHalf(here.w, wx, wy, k, g);
    WaterCell s2 = waterHalf(below.c, sx, sy, k, g);
    precise float maxE = here.e.depth * uniforms.share;
    precise float maxW = here.w.depth * uniforms.share;
    precise float maxS = below.c.depth * uniforms.share;
    WaterFlux east = waterFlux(waterSideX(here.c, c2, cx, 0.5f), waterSideX(here.e, e2, ex, -0.5f), g, maximum, maxE);
    WaterFlux west = waterFlux(waterSideX(here.w, w2, wx, 0.5f), waterSideX(here.c, c2, cx, -0.5f), g, maxW, maximum);
    WaterFlux south = waterFlux(waterSideY(here.c, c2, cy, 0.5f), waterSideY(below.c, s2, sy, -0.5f), g, maximum, maxS);
    vec4 stepped = waterGathered(loadWater(i), c2, cx, cy, east, west, south, north, uniforms);
    STORE_STATE(nextCells, i, stepped);
    if (!(isNumber(stepped.x) && isNumber(stepped.y) && isNumber(stepped.z))) noteLost(uint(stepNumber), uint(i));
    fastest = max(fastest, waterCourant(here.c, uniforms));
    above = here;
    here = below;
    below = next;
    cx = sx;
    cy = sy;
    c2 = s2;
    maximum = maxS;
    north = south;
  }
  if (fastest > uniforms.courant) atomicMax(status.remark, uint(floatBitsToInt(fastest)));
}
