// One bit a slot: alive and in sight. An invocation fills one word, 32 slots. With LEVELS > 1 every level of
// detail has its own words, `words` of them, and a slot's bit is set in one level. FOR_LIGHT: in the box of the
// light's map instead of the camera's frustum. FOR_LAMPS: wherever it is, for the shadow maps of all lamps.
#include "draw/frame_block.glsl"
#include "draw/instances/instance.glsl"
#ifdef FOR_LIGHT
#include "draw/surface/light_map.glsl"
#elif defined FOR_LAMPS
#include "draw/lights/lamp_list.glsl"
#endif
layout(local_size_x = 64) in;
layout(std430, binding = maskBinding) writeonly restrict buffer MaskBlock { uint masks[]; };
uniform int capacity;
uniform int words;
uniform float pointPixels;  // sprites of at most this radius are points
uniform float levelError;  // pixels by which the outline of a coarse shape may miss the true one

#ifdef FOR_LIGHT
bool isSeen(vec3 p, float radius) {
  vec3 place = shadowPlace(p);
  vec3 reach = radius / shadowExtent();
  return all(greaterThan(place + reach, vec3(0))) && all(lessThan(place - reach, vec3(1)));
}
float pixelRadius(vec3 p, float radius) {
  return radius / shadowTexel();
}
// A point is dropped as a whole with its middle.
bool isMiddleSeen(vec3 p) {
  return all(lessThan(abs(shadowPlace(p) - 0.5), vec3(0.4999)));
}
#elif defined FOR_LAMPS
bool isSeen(vec3 p, float radius) {
  return true;
}
// Texels of the map in which it is largest.
float pixelRadius(vec3 p, float radius) {
  float largest = 0.0;
  for (int i = 0; i < LAMPS; ++i) {
    float distance = max(length(lampPlace(i).xyz - p) - radius, lampSampling(i).x);
    largest = max(largest, radius / (distance * lampSampling(i).y));
  }
  return largest;
}
// No sprite is drawn as a point.
bool isMiddleSeen(vec3 p) {
  return false;
}
#else
// Outside when wholly behind one plane of the frustum. A plane is a sum or difference of rows of the matrix.
bool isSeen(vec3 p, float radius) {
  mat4 rows = transpose(frame.viewProjection);
  vec4 at = vec4(p, 1);
  bool seen = true;
  for (int axis = 0; axis < 3; ++axis) {
    vec4 low = rows[3] + rows[axis], high = rows[3] - rows[axis];
    seen = seen && dot(low, at) > -radius * length(low.xyz) && dot(high, at) > -radius * length(high.xyz);
  }
  return seen;
}
#endif

void main() {
  int word = int(gl_GlobalInvocationID.x);
  if (word >= words) return;
  uint found[LEVELS];
  for (int level = 0; level < LEVELS; ++level) found[level] = 0u;
  int last = min(32, capacity - word * 32);
  for (int i = 0; i < last; ++i) {
    vec4 position = texelFetch(positions, word * 32 + i);
    vec4 velocity = texelFetch(velocities, word * 32 + i);
    float radius = instanceSize(position.w) * shapeRadius;
#ifndef FOR_LIGHT
    radius = max(radius, minRadius(position.xyz));
#endif
    if (!(isShown(position, velocity) && radius > 0.0 && isSeen(position.xyz, radius))) continue;
#if LEVELS == 2
    bool fine = pixelRadius(position.xyz, radius) > pointPixels || !isMiddleSeen(position.xyz);
    found[0] |= fine ? 0u : 1u << i;
    found[1] |= fine ? 1u << i : 0u;
#elif LEVELS > 1
    // An icosphere's edges span 63.4 degrees / 2^level; their middles lie 1 - cos(half) inside.
    float missed = pixelRadius(position.xyz, radius);
    int wanted = int(missed * 0.149 > levelError) + int(missed * 0.0489 > levelError) +
                 int(missed * 0.0123 > levelError) + int(missed * 0.0031 > levelError);
    for (int level = 0; level < LEVELS; ++level) found[level] |= level == wanted ? 1u << i : 0u;
#else
    found[0] |= 1u << i;
#endif
  }
  for (int level = 0; level < LEVELS; ++level) masks[level * words + word] = found[level];
}
