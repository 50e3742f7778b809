// Shadow map filter in shader code. Returns the fraction of light that reaches a point, filtered over a few texels.
#include "draw/exact/bindings.glsl"
#include "draw/exact/triangles/triangle.glsl"

// Location of a map in the key buffer.
struct ShadowMap {
  int side;    // side of the map in texels
  int first;   // index of the map's first key
  int stride;  // number of keys from one row of the map to the next
};

// A point that receives light, on a map, and the plane of its surface. Each texel is compared with the plane's nearness
// at the texel's centre, so that a flat surface casts no shadow on itself, however steep it is.
struct Receiver {
  vec2 middle;  // position in texels
  float near;   // nearness
  vec2 rise;    // change of the nearness per texel along the surface
#ifdef PIXEL_EXTENT
  vec2 along;   // extent over which the taps are spread (texels)
#endif
};

// Returns the key of a nearness. A receiver behind every caster counts as inside the map.
uint receiverKey(float near) {
  return nearKey(max(near, 0.0f));
}

// Returns the bilinearly weighted fraction of lit texels around a position (texels).
float litAround(usamplerBuffer keys, ShadowMap map, Receiver r, vec2 place) {
  precise vec2 corner = place - 0.5f;
  precise vec2 whole = floor(corner);
  precise vec2 part = corner - whole;
  precise vec2 way = (whole + 0.5f) - r.middle;
  precise float nearP = r.near + r.rise.x * way.x + r.rise.y * way.y;
  precise float nearQ = nearP + r.rise.x;
  precise float nearR = nearP + r.rise.y;
  precise float nearS = nearQ + r.rise.y;
  ivec2 a = clamp(ivec2(whole), ivec2(0), ivec2(map.side - 1));
  ivec2 b = clamp(ivec2(whole) + 1, ivec2(0), ivec2(map.side - 1));
  int upperRow = map.first + a.y * map.stride, lowerRow = map.first + b.y * map.stride;
  float p = receiverKey(nearP) <= texelFetch(keys, upperRow + a.x).x ? 1.0f : 0.0f;
  float q = receiverKey(nearQ) <= texelFetch(keys, upperRow + b.x).x ? 1.0f : 0.0f;
  float r_ = receiverKey(nearR) <= texelFetch(keys, lowerRow + a.x).x ? 1.0f : 0.0f;
  float s = receiverKey(nearS) <= texelFetch(keys, lowerRow + b.x).x ? 1.0f : 0.0f;
  precise float upper = p + (q - p) * part.x;
  precise float lower = r_ + (s - r_) * part.x;
  precise float lit = upper + (lower - upper) * part.y;
  return lit;
}

// Returns the lit fraction of a tap at the offset `way` (texels). `aside`: position of the tap within the extent, -0.5
// to 0.5.
float litAt(usamplerBuffer keys, ShadowMap map, Receiver r, vec2 way, float aside) {
#ifdef PIXEL_EXTENT
  precise vec2 place = r.middle + (way + r.along * aside);
#else
  precise vec2 place = r.middle + way;
#endif
  return litAround(keys, map, r, place);
}

// Adds the taps at `way` and -`way` to `sum`. Their positions within the extent, `aside` and -`aside`, get the signs
// that move the taps apart.
float withTwo(float sum, usamplerBuffer keys, ShadowMap map, Receiver r, vec2 way, float aside) {
#ifdef PIXEL_EXTENT
  precise float apart = r.along.x * way.x + r.along.y * way.y;
  aside = apart < 0.0f ? -aside : aside;
#endif
  precise float one = sum + litAt(keys, map, r, way, aside);
  precise float two = one + litAt(keys, map, r, -way, -aside);
  return two;
}

// Returns the mean of four taps in a square that is turned by 27 degrees. Together, the steps of the taps form a smooth
// ramp.
float litByFour(usamplerBuffer keys, ShadowMap map, Receiver r, float radius) {
  precise vec2 u = radius * vec2(0.667f, 0.333f);
  precise vec2 v = radius * vec2(-0.333f, 0.667f);
  float first = withTwo(0.0f, keys, map, r, u, 0.375f);
  float sum = withTwo(first, keys, map, r, v, 0.125f);
  precise float fraction = 0.25f * sum;
  return fraction;
}

// 16 points of a sunflower spiral on the unit disc. x: radius exactSqrt((i + 1/2) / 16); y and z: cosine and sine of
// 2.399963 i.
const vec3 sunflower[16] = vec3[](
    vec3(0.176776692f, 0.999999881f, 0.0f), vec3(0.306186229f, -0.737368882f, 0.675490618f),
    vec3(0.395284712f, 0.0874252319f, -0.996171057f), vec3(0.467707157f, 0.608439505f, 0.793600142f),
    vec3(0.530330062f, -0.984713793f, -0.174180642f), vec3(0.586301923f, 0.84375453f, -0.536729038f),
    vec3(0.637377381f, -0.259602129f, 0.965715587f), vec3(0.684653163f, -0.46090889f, -0.887447178f),
    vec3(0.728868961f, 0.939321995f, 0.343036175f), vec3(0.770551741f, -0.924344897f, 0.381558806f),
    vec3(0.810092628f, 0.423844457f, -0.905735254f), vec3(0.847791255f, 0.29928723f, 0.954162836f),
    vec3(0.883883417f, -0.865212858f, -0.501404345f), vec3(0.918558598f, 0.976674676f, -0.214723125f),
    vec3(0.951971591f, -0.575125396f, 0.818065643f), vec3(0.984251082f, -0.128515407f, -0.991707444f));

// Returns the mean of 16 taps. Their positions within the extent do not correlate with their offsets, so the variances
// of filter and extent add up.
float litBySixteen(usamplerBuffer keys, ShadowMap map, Receiver r, float radius) {
  precise float sum = 0.0f;
  for (int i = 0; i < 16; ++i) {
    vec3 point = sunflower[i];
    precise float along = radius * point.x;
    precise vec2 way = along * point.yz;
    precise float aside = (float(7 * i & 15) - 7.5f) * 0.0625f;
    sum = sum + litAt(keys, map, r, way, aside);
  }
  precise float fraction = sum * 0.0625f;
  return fraction;
}
