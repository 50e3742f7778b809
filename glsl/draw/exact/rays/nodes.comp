// Computes the boxes of one level of a hierarchy: boxes of parents around their two children. LEAVES: boxes of leaves
// around their items instead. Node 1 is the root; the children of node n are 2n and 2n + 1. Leaf i is node leaves + i
// and holds the items that heldBy() returns. One invocation computes one node.
#include "draw/exact/rays/bindings.glsl"
#include "draw/exact/rays/ray_box.glsl"
#include "draw/exact/rays/leaf.glsl"
layout(local_size_x = 64) in;
layout(binding = solidUnit) uniform usamplerBuffer sorted;
layout(binding = solidNodeUnit) uniform usamplerBuffer children;
layout(std430, binding = outNodeBinding) writeonly restrict buffer NodeBlock { uvec4 nodes[]; };
uniform int count;
uniform int leaves;
uniform int width;  // number of nodes in this level of the hierarchy

uvec3 boxOf(int i) {
#ifdef BALLS
  return texelFetch(sorted, 2 * i + 1).xyz & uvec3(0x7fffffffu);
#else
  return uvec3(texelFetch(sorted, 3 * i).w, texelFetch(sorted, 3 * i + 1).w, texelFetch(sorted, 3 * i + 2).w) & uvec3(0x7fffffffu);
#endif
}

void main() {
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (i >= width) return;
  int node = width + i;
#ifdef LEAVES
  uvec3 box = uvec3(emptyBoxX, emptyBoxY, emptyBoxZ);
  ivec2 held = heldBy(i, count, leaves);
  for (int k = held.x; k < held.y; ++k) box = joinedBox(box, boxOf(k));
#else
  uvec3 box = joinedBox(texelFetch(children, 2 * node).xyz, texelFetch(children, 2 * node + 1).xyz);
#endif
  nodes[node] = uvec4(box, 0u);
}
