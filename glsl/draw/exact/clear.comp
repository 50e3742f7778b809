// Clears a visibility buffer: sets all depth keys and primitive ids to 0xffffffff, which marks a sample as empty. One
// invocation clears four samples.
#include "draw/exact/bindings.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = nearBinding) writeonly restrict buffer NearBlock { uvec4 nearKeys[]; };
layout(std430, binding = idBinding) writeonly restrict buffer IdBlock { uvec4 ids[]; };
uniform int quads;
uniform bool both;  // true if keys and ids are in two separate buffers

void main() {
  int i = int(gl_WorkGroupID.y * gl_NumWorkGroups.x * 64u + gl_GlobalInvocationID.x);
  if (i >= quads) return;
  nearKeys[i] = uvec4(0xffffffffu);
  if (both) ids[i] = uvec4(0xffffffffu);
}
