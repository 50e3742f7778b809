// Grows the bounds by one surface. Each invocation reduces a strided share of the vertices first.
#include "draw/bounds.glsl"
layout(local_size_x = 64) in;
layout(binding = 0) uniform samplerBuffer positions;
uniform int vertexCount;
uniform int invocations;
uniform mat4 model;

void main() {
  int first = int(gl_GlobalInvocationID.x);
  if (first >= min(invocations, vertexCount)) return;
  vec3 low = vec3(3.4e38), high = vec3(-3.4e38);
  vec2 groundLow = vec2(3.4e38), groundHigh = vec2(-3.4e38);
  for (int i = first; i < vertexCount; i += invocations) {
    vec3 p = (model * vec4(texelFetch(positions, i).xyz, 1.0)).xyz;
    if (!(dot(abs(p), vec3(1)) < 1e6)) continue;  // lost particles must not blow the map up
    vec3 q = vec3(dot(p, frame.lightRight.xyz), dot(p, frame.lightUp.xyz), dot(p, frame.sunDirection.xyz));
    vec2 g = p.xz - frame.sunDirection.xz * ((p.y - frame.groundColor.w) / sunHeight());
    low = min(low, q);
    high = max(high, q);
    groundLow = min(groundLow, g);
    groundHigh = max(groundHigh, g);
  }
  if (low.x > high.x) return;
  for (int axis = 0; axis < 3; ++axis) {
    atomicMin(boundLow[axis], orderedKey(low[axis]));
    atomicMax(boundHigh[axis], orderedKey(high[axis]));
  }
  for (int axis = 0; axis < 2; ++axis) {
    atomicMin(boundLow[3 + axis], orderedKey(groundLow[axis]));
    atomicMax(boundHigh[3 + axis], orderedKey(groundHigh[axis]));
  }
}
