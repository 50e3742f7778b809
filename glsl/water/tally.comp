// Measures the water once per frame (src/sim/water/quantities.cpp). Sums the depth, h |u|^2 / 2, h (w + b) / 2 (depth
// h, velocity u, level w, bed b) and the number of wet cells. Determines the maxima of Courant number, speed and depth.
#include "common/bindings.glsl"
#include "common/exact.glsl"
#include "common/memory.glsl"
#include "water/bindings.glsl"
#include "water/types.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(cellsBinding, CellBlock, cells)
layout(std140, binding = stepBinding) uniform WaterBlock { WaterStep water; };
uniform ivec2 size;
uniform float shallow;  // Depth below which a cell is not wet, m
#include "water/model.glsl"

struct Tallied {
  vec4 sums;
  vec4 maximum;
};

Tallied tallied(int i) {
  vec4 texel = LOAD_INPUT(cells, i);
  WaterCell c = waterCell(texel, water.thin);
  bool wet = c.depth > shallow, moves = c.depth > water.thin;
  precise float squared = c.u * c.u + c.v * c.v;
  precise float kinetic = 0.5f * c.depth * squared;
  precise float potential = 0.5f * c.depth * (texel.x + texel.w);
  Tallied t;
  t.sums = vec4(c.depth, moves ? kinetic : 0.0f, potential, wet ? 1.0f : 0.0f);
  t.maximum = vec4(moves ? waterCourant(c, water) : 0.0f, moves ? exactSqrt(squared) : 0.0f, c.depth, 0.0f);
  return t;
}
#include "grid/tally.glsl"

void main() {
  int lane = int(gl_GlobalInvocationID.x);
  if (lane < tallyLanes) tallyLane(lane, size.x * size.y);
}
