// Replaces the nearest face of each node by the signed distance in integer units. One invocation per node.
#include "collide/distance/kernel.glsl"

void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i >= nodes.w) return;
  float distance_ = signedDistance(placeOf(i), int(LOAD_WORDS(searches, i).y));
  STORE_WORDS(searches, i, uvec4(uint(wholeUnits(distance_, perUnit)), 0u, 0u, 0u));
}
