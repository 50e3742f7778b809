// Fraction of a lamp's light that reaches a place, filtered over a few texels of its maps, by reads of our own
// (draw/lights/lamp_shadow.glsl). Of a lamp, `maps` has: x texels on a side of a map, y those of a row of all maps, z the row
// where its own begin, w fraction of a map's side that 90 degrees span.
#include "draw/exact/bindings.glsl"
#include "draw/lights/faces.glsl"
#include "draw/exact/triangle.glsl"
layout(binding = lampMapUnit) uniform usamplerBuffer lampKeys;

// Lit texels around a place of a map (texels), weighted linearly.
float lampLitAround(vec2 place, uint key, int side, int first, int stride) {
  precise vec2 corner = place - 0.5f;
  precise vec2 whole = floor(corner);
  precise vec2 part = corner - whole;
  ivec2 a = clamp(ivec2(whole), ivec2(0), ivec2(side - 1)), b = clamp(ivec2(whole) + 1, ivec2(0), ivec2(side - 1));
  int upperRow = first + a.y * stride, lowerRow = first + b.y * stride;
  float p = key <= texelFetch(lampKeys, upperRow + a.x).x ? 1.0f : 0.0f;
  float q = key <= texelFetch(lampKeys, upperRow + b.x).x ? 1.0f : 0.0f;
  float r = key <= texelFetch(lampKeys, lowerRow + a.x).x ? 1.0f : 0.0f;
  float s = key <= texelFetch(lampKeys, lowerRow + b.x).x ? 1.0f : 0.0f;
  precise float upper = p + (q - p) * part.x;
  precise float lower = r + (s - r) * part.x;
  precise float lit = upper + (lower - upper) * part.y;
  return lit;
}

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
  float radius = sampling.z;
#if LAMP_TAPS == 4
  // A square turned by 27 degrees, as for the sun.
  precise vec2 u = radius * vec2(0.667f, 0.333f);
  precise vec2 v = radius * vec2(-0.333f, 0.667f);
  precise vec2 one = middle + u;
  precise vec2 two = middle - u;
  precise vec2 three = middle + v;
  precise vec2 four = middle - v;
  precise float sum = lampLitAround(one, key, side, first, stride) + lampLitAround(two, key, side, first, stride) +
                      lampLitAround(three, key, side, first, stride) + lampLitAround(four, key, side, first, stride);
  precise float fraction = 0.25f * sum;
#else
  precise float sum = 0.0f;
  for (int i = 0; i < LAMP_TAPS; ++i) {  // sunflower disc
    precise float turn = 2.399963f * float(i);
    precise float far = (float(i) + 0.5f) * 0.0625f;
    precise float along = radius * exactSqrt(far);
    precise vec2 tap = middle + along * vec2(exactCos(turn), exactSin(turn));
    sum = sum + lampLitAround(tap, key, side, first, stride);
  }
  precise float fraction = sum * 0.0625f;
#endif
  return fraction;
}
