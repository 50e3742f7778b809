// Converts the velocities of a user's grid into the flow that wind-driven objects read (fluid/wind_array.glsl): u at
// the centre of each cell's left face, v at the centre of its top face, as the mean of the two adjacent cells. A ring
// of one cell surrounds the grid. Cells outside the grid have the velocity of the nearest cell inside. One invocation
// per element of the ring and the grid.
#include "common/memory.glsl"
layout(local_size_x = 64) in;
INPUT_ARRAY(0, CellBlock, cells)  // x and y: components of the velocity towards increasing x and y
#ifdef TEXEL_PATH
layout(std430, binding = 1) writeonly buffer WindBlock { vec4 wind[]; };
#else
layout(std430, binding = 1) writeonly buffer WindBlock { float wind[]; };  // all values of u, then all values of v
#endif
uniform ivec2 size;   // number of cells per axis
uniform float scale;  // velocity in cells/s per unit of the user's velocity

vec2 velocityAt(int x, int y) {
  x = clamp(x, 0, size.x - 1);
  y = clamp(y, 0, size.y - 1);
  return LOAD_INPUT(cells, y * size.x + x).xy;
}

void main() {
  int i = int(gl_GlobalInvocationID.x), width = size.x + 2, count = width * (size.y + 2);
  if (i >= count) return;
  int x = i % width - 1, y = i / width - 1;
  vec2 here = velocityAt(x, y);
  precise float u = (velocityAt(x - 1, y).x + here.x) * 0.5 * scale;
  precise float v = (velocityAt(x, y - 1).y + here.y) * 0.5 * scale;
#ifdef TEXEL_PATH
  wind[i] = vec4(u, v, 0.0, 0.0);
#else
  wind[i] = u;
  wind[count + i] = v;
#endif
}
