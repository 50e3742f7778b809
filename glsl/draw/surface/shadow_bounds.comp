// Extends the bounds of the shadow casters by one surface. INSTANCES: by instances instead. BOX: by a box instead. Each
// invocation first reduces the vertices of a strided range, then updates the bounds with atomics.
#include "draw/instances/bounds.glsl"
layout(local_size_x = 64) in;
uniform int vertexCount;
uniform int invocations;
#ifdef INSTANCES
#include "draw/instances/instance.glsl"
// Returns the bounding ball of item i. xyz: centre; w: radius.
vec4 ball(int i) {
  vec4 position = texelFetch(positions, i);
  bool shown = isShown(position, texelFetch(velocities, i));
  return vec4(shown ? position.xyz : vec3(1e30), instanceRadius(position.w));
}
#elif defined(BOX)
uniform vec3 corners[2];
vec4 ball(int i) {
  return vec4(corners[i & 1].x, corners[i >> 1 & 1].y, corners[i >> 2 & 1].z, 0);
}
#else
#include "draw/surface/vertex_pull.glsl"
vec4 ball(int i) {
  return vec4(worldPoint(i), 0);
}
#endif

void main() {
  int first = int(gl_GlobalInvocationID.x);
  if (first >= min(invocations, vertexCount)) return;
  vec3 low = vec3(3.4e38), high = vec3(-3.4e38);
  vec2 groundLow = vec2(3.4e38), groundHigh = vec2(-3.4e38);
  float perHeight = exactReciprocal(sunHeight());
  precise vec2 away = frame.sunDirection.xz * perHeight;  // shift of the shadow along the ground per metre of height
  for (int i = first; i < vertexCount; i += invocations) {
    vec4 found = ball(i);
    vec3 p = found.xyz;
    precise float far = abs(p.x) + abs(p.y) + abs(p.z) + found.w;
    if (!(isNumber(far) && far < 1e6)) continue;  // ignores particles that are extremely far away, which would enlarge
                                                  // the map without limit
    vec3 q = vec3(exactDot(p, frame.lightRight.xyz), exactDot(p, frame.lightUp.xyz),
                  exactDot(p, frame.sunDirection.xyz));
    precise vec2 g = p.xz - away * (p.y - frame.groundHeight);
    // The shadow of a ball on the ground extends to radius / sin(elevation of the sun) from the shadow's centre.
    precise float reach = found.w * perHeight;
    precise vec3 nearer = q - found.w, farther = q + found.w;
    precise vec2 groundNearer = g - reach, groundFarther = g + reach;
    low = min(low, nearer);
    high = max(high, farther);
    groundLow = min(groundLow, groundNearer);
    groundHigh = max(groundHigh, groundFarther);
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
