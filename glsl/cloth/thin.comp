// Computes the position and velocity changes of a grid's vertices by thin colliders. Tests the six edges and six faces
// around each vertex, with the same triangulation as for drawing. One invocation per vertex.
#include "cloth/kernel.glsl"
layout(local_size_x = 8, local_size_y = 8) in;
#include "cloth/thin_kernel.glsl"

// Returns the neighbour k of six. A face lies between neighbour k and neighbour k + 1.
ivec2 around(ivec2 at, int k) {
  int x = k == 0 || k == 5 ? 1 : k == 2 || k == 3 ? -1 : 0;
  int y = k == 1 || k == 2 ? 1 : k == 4 || k == 5 ? -1 : 0;
  return at + ivec2(x, y);
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  if (at.x >= size.x || at.y >= size.y) return;
  int i = at.y * size.x + at.x;
  Corner here = loadCorner(i);
  ThinPush sum = notPushed();
  int last = stepData.colliderCount + stepData.thinCount;
  for (int c = stepData.colliderCount; c < last; ++c) {
    if (here.inverseMass == 0.0f || !mayMeet(c, here)) continue;
    ThinPush maximum = notPushed();
    for (int k = 0; k < 6; ++k) {
      ivec2 first = around(at, k), second = around(at, k == 5 ? 0 : k + 1);
      bool hasFirst = first.x >= 0 && first.y >= 0 && first.x < size.x && first.y < size.y;
      bool hasSecond = second.x >= 0 && second.y >= 0 && second.x < size.x && second.y < size.y;
      if (!hasFirst) continue;
      Corner one = loadCorner(first.y * size.x + first.x);
      maximum = pushedByEdge(maximum, c, here, one);
      if (hasSecond) maximum = pushedByFace(maximum, c, here, one, loadCorner(second.y * size.x + second.x));
    }
    sum = together(sum, maximum);
  }
  leaveShift(i, sum);
}
