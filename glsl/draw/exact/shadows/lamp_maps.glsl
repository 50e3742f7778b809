// Fraction of a lamp's light that reaches a place, filtered over a few texels of its maps, by reads of our own
// (draw/lights/lamp_shadow.glsl). Of a lamp, `maps` has: x texels on a side of a map, y those of a row of all maps, z the row
// where its own begin, w fraction of a map's side that 90 degrees span.
#include "draw/lights/faces.glsl"
#include "draw/exact/shadows/shadow_filter.glsl"
layout(binding = lampMapUnit) uniform usamplerBuffer lampKeys;

// `nl`: cosine between normal and lamp. Looked up a step to the lit side of the surface, it does not shade itself.
float lampFraction(int lamp, vec3 from, vec3 normal, float nl) {
  vec4 maps = lampMaps(lamp), sampling = lampSampling(lamp);
  vec3 a = abs(from);
  precise float turned = 4.0f * nl;
  precise float lift = clamp(turned, -1.0f, 1.0f) * (sampling.y * max(a.x, max(a.y, a.z))) * (0.5f + 0.5f * sampling.z);
  precise vec3 lifted = from + normal * lift;
  int face = faceOf(lifted);
  vec3 q = onFace(face, lifted);
  float perAlong = exactReciprocal(max(q.x, 1e-6f));
  precise vec2 middle = (0.5f + q.yz * (0.5f * maps.w * perAlong)) * maps.x;
  precise float near = sampling.x * perAlong;
  uint key = nearKey(min(near, 1.0f));
  int side = int(maps.x), stride = int(maps.y), row = int(maps.z);
  int first = row * stride;
  first += face * side;
  ShadowMap map = ShadowMap(side, first, stride);
#if LAMP_TAPS == 4
  return litByFour(lampKeys, map, middle, key, sampling.z);
#else
  return litBySixteen(lampKeys, map, middle, key, sampling.z);
#endif
}
