// One step; an invocation takes one cell.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "common/status.glsl"
#include "water/bindings.glsl"
#include "water/types.glsl"
layout(local_size_x = 16, local_size_y = 8) in;
INPUT_ARRAY(cellsBinding, CellBlock, cells)
STATE_ARRAY(nextCellsBinding, NextBlock, nextCells)
layout(std140, binding = stepBinding) uniform WaterBlock { WaterStep water; };
uniform ivec2 size;
uniform int stepNumber;  // of the frame, from 1

vec4 loadWater(int x, int y) {
  return LOAD_INPUT(cells, y * size.x + x);
}
#include "water/model.glsl"
#include "water/step.glsl"

void main() {
  int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
  if (x >= size.x || y >= size.y) return;
  int i = y * size.x + x;
  vec4 next = waterStepped(x, y);
  STORE_STATE(nextCells, i, next);
  if (!(isNumber(next.x) && isNumber(next.y) && isNumber(next.z))) noteLost(uint(stepNumber), uint(i));
  float courant = waterCourant(waterCell(loadWater(x, y), water.thin), water);
  if (courant > water.courant) atomicMax(status.remark, uint(floatBitsToInt(courant)));
}
