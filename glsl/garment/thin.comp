// Computes the position and velocity changes of a mesh's vertices by thin colliders, from the edges and faces around
// each vertex. One invocation per vertex.
#include "garment/kernel.glsl"
layout(local_size_x = 64) in;
#include "cloth/thin_kernel.glsl"
INPUT_WORDS(fansBinding, FanBlock, fans)
INPUT_WORDS(ringsBinding, RingBlock, rings)

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= count) return;
  Corner here = loadCorner(i);
  uvec4 fan = LOAD_INPUT_WORDS(fans, i);
  ThinPush sum = notPushed();
  int last = stepData.colliderCount + stepData.thinCount;
  for (int c = stepData.colliderCount; c < last; ++c) {
    if (here.inverseMass == 0.0f || !mayMeet(c, here)) continue;
    ThinPush maximum = notPushed();
    for (uint k = 0u; k < fan.y; ++k) {
      uvec4 ring = LOAD_INPUT_WORDS(rings, int(fan.x + k));
      Corner one = loadCorner(int(ring.x)), other = loadCorner(int(ring.y));
      maximum = pushedByEdge(maximum, c, here, one);
      maximum = pushedByEdge(maximum, c, here, other);
      maximum = pushedByFace(maximum, c, here, one, other);
    }
    sum = together(sum, maximum);
  }
  leaveShift(i, sum);
}
