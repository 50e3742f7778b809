// Boxes of faces: of all places where their corners may be, and half the thickness around.
#include "contact/kernel.glsl"
#include "contact/search.glsl"
layout(local_size_x = 64) in;
INPUT_WORDS(leavesBinding, LeafBlock, leaves)
layout(std430, binding = boxesBinding) restrict writeonly buffer BoxBlock { vec4 boxes[]; };

Hull hullOf(uint vertex) {
  int v = int(vertex);
  Hull hull;
  hull.low = pointAt(lowSection, v).xyz;
  hull.high = pointAt(highSection, v).xyz;
  return widened(hull, pointAt(nextSection, v).w);
}

void main() {
  int i = int(gl_GlobalInvocationID.x), count = 1 << contactStep.levels;
  if (i >= count) return;
  uvec4 leaf = LOAD_INPUT_WORDS(leaves, i);
  Hull box = together(together(hullOf(leaf.x), hullOf(leaf.y)), hullOf(leaf.z));
  bool none = hasNoFace(leaf);  // the box that overlaps nothing, and adds nothing to what is above it
  boxes[2 * (count + i)] = vec4(none ? vec3(1e30f) : box.low, 0.0f);
  boxes[2 * (count + i) + 1] = vec4(none ? vec3(-1e30f) : box.high, 0.0f);
}
