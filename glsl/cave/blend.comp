// Mixes the cells of two stages to a field of floats whose contours at 0.5 move from the walls of the stage before to the
// current walls. One invocation per cell.
#include "cave/cells.glsl"
layout(local_size_x = 32) in;
layout(std430, binding = beforeBinding) restrict readonly buffer BeforeBlock { uint cellsBefore[]; };
layout(std430, binding = blendedBinding) restrict writeonly buffer BlendedBlock { float blended[]; };
uniform float fraction;  // 0: the stage before; 1: the current stage
uniform uint seed;

uint before(int x, int y) {
  if (x < 0 || y < 0 || x >= size.x || y >= size.y) return 1u;
  return cellsBefore[y * rowWords + (x >> 5)] >> uint(x & 31) & 1u;
}

void main() {
  int x = int(gl_GlobalInvocationID.x), y = int(gl_GlobalInvocationID.y);
  if (x >= 32 * rowWords || y >= size.y) return;
  uint now = cells[y * rowWords + (x >> 5)] >> uint(x & 31) & 1u;
  uint around = before(x - 1, y - 1) + before(x, y - 1) + before(x + 1, y - 1) + before(x - 1, y) + before(x + 1, y) +
                before(x - 1, y + 1) + before(x, y + 1) + before(x + 1, y + 1);
  uint newAround = now == 1u ? around : 8u - around;
  uint hash = hash3(uvec3(uint(x), uint(y), seed)).y;
  blended[numberOf(x, y)] = blendedCell(before(x, y), now, newAround, hash, fraction);
}
