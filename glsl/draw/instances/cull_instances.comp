// Culls instances: sets the bit of an instance if it is alive and in view. One invocation writes one word (32
// instances). LEVELS > 1: every level of detail has a separate range of `words` words, and an instance's bit is set in
// one level. FOR_LIGHT: culls against the box of the sun's shadow map instead of the camera's frustum. FOR_LAMPS: keeps
// all living instances, for the shadow maps of all lamps.
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
uniform float pointPixels;  // max radius (pixels) of sprites that are drawn as points
uniform float levelError;  // max error (pixels) of a coarse shape's outline

#ifdef FOR_LIGHT
// Values that all view tests of an invocation need.
struct Sight {
  vec3 perExtent;  // 1 / size of the shadow map's box along each axis (1/m)
  float perTexel;
};
Sight sightNow() {
  vec3 extent = shadowExtent();
  float perSide = exactReciprocal(extent.x);
  return Sight(vec3(perSide, perSide, exactReciprocal(extent.z)), exactReciprocal(shadowTexel()));
}
bool isSeen(Sight sight, vec3 p, float radius) {
  precise vec3 reach = radius * sight.perExtent;
  precise vec3 place = shadowPlace(p), high = place + reach, low = place - reach;
  return all(greaterThan(high, vec3(0))) && all(lessThan(low, vec3(1)));
}
float pixelRadius(Sight sight, vec3 p, float radius) {
  precise float texels = radius * sight.perTexel;
  return texels;
}
// Returns true if the centre is in view. OpenGL clips a point primitive as a whole by its centre.
bool isMiddleSeen(vec3 p) {
  precise vec3 aside = shadowPlace(p) - 0.5;
  return all(lessThan(abs(aside), vec3(0.4999)));
}
#elif defined FOR_LAMPS
struct Sight {
  bool everywhere;
};
Sight sightNow() {
  return Sight(true);
}
bool isSeen(Sight sight, vec3 p, float radius) {
  return sight.everywhere;
}
// Returns the largest radius, in texels, of the instance in any lamp's shadow map.
float pixelRadius(Sight sight, vec3 p, float radius) {
  float largest = 0.0;
  for (int i = 0; i < LAMPS; ++i) {
    precise vec3 to = lampPlace(i).xyz - p;
    precise float distance = exactSqrt(exactDot(to, to)) - radius;
    precise float texel = max(distance, lampSampling(i).x) * lampSampling(i).y;
    precise float texels = radius * exactReciprocal(texel);
    largest = max(largest, texels);
  }
  return largest;
}
// Returns false, so that no sprite is drawn as a point.
bool isMiddleSeen(vec3 p) {
  return false;
}
#else
struct Sight {
  vec4 sides[6];  // planes of the frustum; the dot product with (position, 1) is the distance (m) on the inner side
};
// Returns the frustum's planes. Each plane is a sum or difference of two rows of the matrix.
Sight sightNow() {
  mat4 rows = transpose(frame.viewProjection);
  Sight sight;
  for (int axis = 0; axis < 3; ++axis) {
    precise vec4 low = rows[3] + rows[axis], high = rows[3] - rows[axis];
    precise vec4 minimum = low * exactInverseSqrt(exactDot(low.xyz, low.xyz));
    precise vec4 maximum = high * exactInverseSqrt(exactDot(high.xyz, high.xyz));
    sight.sides[2 * axis] = minimum;
    sight.sides[2 * axis + 1] = maximum;
  }
  return sight;
}
// Returns true unless the ball is completely behind one plane.
bool isSeen(Sight sight, vec3 p, float radius) {
  bool seen = true;
  for (int i = 0; i < 6; ++i) seen = seen && exactDot(sight.sides[i], vec4(p, 1)) > -radius;
  return seen;
}
float pixelRadius(Sight sight, vec3 p, float radius) {
  return pixelRadius(p, radius);
}
#endif

void main() {
  int word = int(gl_GlobalInvocationID.x);
  if (word >= words) return;
  uint found[LEVELS];
  for (int level = 0; level < LEVELS; ++level) found[level] = 0u;
  int last = min(32, capacity - word * 32);
  Sight sight = sightNow();
  for (int i = 0; i < last; ++i) {
    vec4 position = texelFetch(positions, word * 32 + i);
    vec4 velocity = texelFetch(velocities, word * 32 + i);
    float radius = instanceRadius(position.w);
#ifndef FOR_LIGHT
    radius = max(radius, minRadius(position.xyz));
#endif
    if (!(isShown(position, velocity) && radius > 0.0 && isSeen(sight, position.xyz, radius))) continue;
#if LEVELS == 2
    bool fine = pixelRadius(sight, position.xyz, radius) > pointPixels || !isMiddleSeen(position.xyz);
    found[0] |= fine ? 0u : 1u << i;
    found[1] |= fine ? 1u << i : 0u;
#elif LEVELS > 1
    // Relative outline error of the icosphere levels. An edge spans 63.4 degrees / 2^level, and its middle is 1 -
    // cos(half that angle) inside the unit sphere.
    precise vec4 missed = pixelRadius(sight, position.xyz, radius) * vec4(0.149, 0.0489, 0.0123, 0.0031);
    int wanted = int(missed.x > levelError) + int(missed.y > levelError) + int(missed.z > levelError) +
                 int(missed.w > levelError);
    for (int level = 0; level < LEVELS; ++level) found[level] |= level == wanted ? 1u << i : 0u;
#else
    found[0] |= 1u << i;
#endif
  }
  for (int level = 0; level < LEVELS; ++level) masks[level * words + word] = found[level];
}
