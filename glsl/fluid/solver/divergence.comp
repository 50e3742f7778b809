// Computes the right-hand side, which is the negative net outflow of each cell, in blocks of 2x2 cells, and clears the
// correction.
#include "fluid/grid.glsl"
#include "fluid/solver/solve_control.glsl"
layout(local_size_x = 16, local_size_y = 4) in;
layout(std430, binding = poolOutBinding) writeonly buffer PoolOutBlock { vec4 poolOut[]; };
uniform int rhsStart;

float missingIn(int x, int y) {
  return x < size.x && y < size.y ? missingFlow(x, y) : 0.0;
}

float speedIn(int x, int y) {
  vec4 cell = flowAt(min(x, size.x), min(y, size.y));
  return max(abs(cell.x), abs(cell.y));
}

void main() {
  ivec2 block = ivec2(gl_GlobalInvocationID.xy);
  ivec2 blocks = size / 2 + 1;
  vec4 missing = vec4(0.0);
  float speed = 0.0;
  if (block.x < blocks.x && block.y < blocks.y) {
    int x = 2 * block.x, y = 2 * block.y;
    missing = vec4(missingIn(x, y), missingIn(x + 1, y), missingIn(x, y + 1), missingIn(x + 1, y + 1));
    speed = max(max(speedIn(x, y), speedIn(x + 1, y)), max(speedIn(x, y + 1), speedIn(x + 1, y + 1)));
    int element = block.y * blocks.x + block.x;
    poolOut[element] = vec4(0.0);
    poolOut[blocks.x * blocks.y + element] = vec4(0.0);
    poolOut[rhsStart + element] = missing;
  }
  vec4 sizes = abs(missing);
  noteMaximum(max(max(sizes.x, sizes.y), max(sizes.z, sizes.w)), speed, 0.0);
}
