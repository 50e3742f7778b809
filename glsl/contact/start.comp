// Computes the position to which each vertex can be held back: its position at the substep's start, displaced by
// solids. One invocation per vertex.
#include "contact/kernel.glsl"
layout(local_size_x = 64) in;
layout(std430, binding = talliesBinding) restrict readonly buffer TallyBlock { ivec4 tallies[]; };

void main() {
  int v = int(gl_GlobalInvocationID.x);
  if (v >= contactStep.vertices) return;
  vec3 up = intBitsToFloat(tallies[upSection * contactStep.vertices + v].xyz);
  vec3 down = intBitsToFloat(tallies[downSection * contactStep.vertices + v].xyz);
  keepPoint(startSection, v, vec4(carriedTo(pointAt(nowSection, v), up, down), 0.0f));
}
