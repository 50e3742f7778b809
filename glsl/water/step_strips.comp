// Variant of step.comp for storage buffers, used on GPUs. The arithmetic is the same, but it is done only once per
// cell, except at the borders of a strip. A workgroup of 32 columns moves down `rows` rows. For each row, an invocation
// computes its cell's slopes and half step, the flux to the east and the flux from above. Neighbours exchange values
// through shared memory. The outermost two columns on each side serve only as neighbours, so strips start 28 columns
// apart.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/status.glsl"
#include "water/bindings.glsl"
#include "water/types.glsl"
const int columns = 32;
layout(local_size_x = columns) in;
INPUT_ARRAY(cellsBinding, CellBlock, cells)
STATE_ARRAY(nextCellsBinding, NextBlock, nextCells)
layout(std140, binding = stepBinding) uniform WaterBlock { WaterStep water; };
uniform ivec2 size;
uniform int stepNumber;  // Step of the frame, counted from 1
uniform int rows;        // Number of rows of a strip

vec4 loadWater(int i) {
  return LOAD_INPUT(cells, i);
}
#include "water/model.glsl"
#include "water/step.glsl"

shared vec4 sharedCells[columns];  // Current row: level, depth, u, v
shared vec4 westSides[columns];    // West sides of the row's cells: level, bed, along, across
shared vec4 eastFluxes[columns];   // East fluxes: mass, behind, across

WaterCell cellOf(int column) {
  vec4 v = sharedCells[column];
  return WaterCell(v.x, v.y, v.z, v.w);
}

void main() {
  int column = int(gl_LocalInvocationID.x);
  int x = int(gl_WorkGroupID.x) * (columns - 4) + column - 2;
  int top = int(gl_WorkGroupID.y) * rows;
  ivec2 grid = size;
  int end = min(top + rows, grid.y);
  bool writes = column >= 2 && column < columns - 2 && x < grid.x;
  x = min(x, grid.x + 1);
  int west = max(column - 1, 0), east = min(column + 1, columns - 1);
  WaterStep uniforms = water;
  float g = uniforms.gravity, dry = uniforms.dry, k = uniforms.halfRatio;
  // The rows y - 1, y and y + 1; for row y - 1 also its half step, slopes and fluxes.
  WaterCell above = waterAt(x, top - 2, uniforms, grid), here = waterAt(x, top - 1, uniforms, grid);
  WaterCell a2 = here, ax = here, ay = here;
  WaterFlux nothing = WaterFlux(0.0f, 0.0f, 0.0f, 0.0f);
  WaterFlux aboveEast = nothing, aboveWest = nothing, north = nothing;
  float fastest = 0.0f;
  for (int y = top - 1; y <= end; ++y) {
    WaterCell below = waterAt(x, y + 1, uniforms, grid);
    sharedCells[column] = vec4(here.level, here.depth, here.u, here.v);
    barrier();
    WaterCell e = cellOf(east);
    WaterCell cx = waterSlope(cellOf(west), here, e, dry);
    WaterCell cy = waterSlope(above, here, below, dry);
    WaterCell c2 = waterHalf(here, cx, cy, k, g);
    WaterSide side = waterSideX(here, c2, cx, -0.5f);
    westSides[column] = vec4(side.level, side.bed, side.along, side.across);
    barrier();
    vec4 v = westSides[east];
    precise float maximum = here.depth * uniforms.share;
    precise float maxEast = e.depth * uniforms.share;
    WaterFlux fluxEast = waterFlux(waterSideX(here, c2, cx, 0.5f), WaterSide(v.x, v.y, v.z, v.w), g, maximum, maxEast);
    eastFluxes[column] = vec4(fluxEast.mass, fluxEast.behind, fluxEast.across, 0.0f);
    barrier();
    WaterFlux fluxWest = fluxEast;
    fluxWest.mass = eastFluxes[west].x;
    fluxWest.behind = eastFluxes[west].y;
    fluxWest.across = eastFluxes[west].z;
    precise float maxAbove = above.depth * uniforms.share;
    WaterFlux south = waterFlux(waterSideY(above, a2, ay, 0.5f), waterSideY(here, c2, cy, -0.5f), g, maxAbove, maximum);
    if (writes && y > top) {
      int i = (y - 1) * grid.x + x;
      vec4 stepped = waterGathered(loadWater(i), a2, ax, ay, aboveEast, aboveWest, south, north, uniforms);
      STORE_STATE(nextCells, i, stepped);
      if (!(isNumber(stepped.x) && isNumber(stepped.y) && isNumber(stepped.z))) noteLost(uint(stepNumber), uint(i));
      fastest = max(fastest, waterCourant(above, uniforms));
    }
    above = here;
    here = below;
    a2 = c2;
    ax = cx;
    ay = cy;
    aboveEast = fluxEast;
    aboveWest = fluxWest;
    north = south;
  }
  if (fastest > uniforms.courant) atomicMax(status.remark, uint(floatBitsToInt(fastest)));
}
