// A texture by reads of our own: between texels and levels in proportion, along the longer side of what a pixel covers by
// up to four taps. Texels are linear light in 1/65535.
#include "draw/bindings.glsl"
#include "common/exact.glsl"
layout(binding = albedoUnit) uniform usampler2D albedo;
uniform ivec2 albedoSize;
uniform int albedoLevels;
uniform bool albedoRepeats;  // else its border goes on

// A place in uv, and its change over a pixel to the right and up.
struct Seen {
  vec2 at, across, up;
};

vec3 albedoTexel(int x, int y, int level) {
  precise vec3 light = vec3(texelFetch(albedo, ivec2(x, y), level).rgb) * 1.5259022e-5f;
  return light;
}

// Between the four texels around.
vec3 albedoBetween(vec2 uv, int level) {
  ivec2 size = max(albedoSize >> level, ivec2(1));
  precise vec2 whole = floor(uv);
  precise vec2 turn = uv - whole;
  vec2 place = albedoRepeats ? turn : clamp(uv, vec2(0), vec2(1));
  precise vec2 corner = place * vec2(size) - 0.5f;
  precise vec2 first = floor(corner);
  precise vec2 part = corner - first;
  ivec2 a = ivec2(first), b = a + 1;
  a = albedoRepeats ? a + size * ivec2(lessThan(a, ivec2(0))) : max(a, ivec2(0));
  b = albedoRepeats ? b - size * ivec2(greaterThanEqual(b, size)) : min(b, size - 1);
  vec3 p = albedoTexel(a.x, a.y, level), q = albedoTexel(b.x, a.y, level);
  vec3 r = albedoTexel(a.x, b.y, level), s = albedoTexel(b.x, b.y, level);
  precise vec3 upper = p + (q - p) * part.x;
  precise vec3 lower = r + (s - r) * part.x;
  precise vec3 light = upper + (lower - upper) * part.y;
  return light;
}

// Squares of the lengths of what a pixel covers, in texels.
vec2 texelsCovered(Seen seen) {
  precise vec2 across = seen.across * vec2(albedoSize);
  precise vec2 up = seen.up * vec2(albedoSize);
  precise vec2 covered = vec2(across.x * across.x + across.y * across.y, up.x * up.x + up.y * up.y);
  return min(covered, 1e12f);
}

float texelsAPixel(Seen seen) {
  vec2 covered = texelsCovered(seen);
  return exactSqrt(max(covered.x, covered.y));
}

// `shift`: seen from so many pixels to the right and up.
vec3 textureSeen(Seen seen, vec2 shift) {
  const int maxTaps = 4;
  vec2 covered = texelsCovered(seen);
  float longer = exactSqrt(max(covered.x, covered.y)), shorter = exactSqrt(min(covered.x, covered.y));
  precise float quarter = longer * 0.25f;
  float width = max(max(quarter, shorter), 1.0f);
  // Level and what lies between it and the next: the width in powers of two, straight between them.
  int bits = floatBitsToInt(width);
  int level = (bits >> 23) - 127;
  precise float part = intBitsToFloat((bits & 0x7fffff) | 0x3f800000) - 1.0f;
  if (level >= albedoLevels - 1) {
    level = albedoLevels - 1;
    part = 0.0f;
  }
  precise float ratio = longer * exactReciprocal(width) + 0.99f;
  int taps = clamp(int(ratio), 1, maxTaps);
  float perTap = taps == 1 ? 1.0f : taps == 2 ? 0.5f : taps == 3 ? 0.33333334f : 0.25f;
  vec2 along = covered.x >= covered.y ? seen.across : seen.up;
  precise vec2 middle = seen.at + seen.across * shift.x + seen.up * shift.y;
  precise vec3 sum = vec3(0);
  for (int i = 0; i < taps; ++i) {
    precise float aside = (float(i) + 0.5f) * perTap - 0.5f;
    precise vec2 uv = middle + along * aside;
    vec3 fine = albedoBetween(uv, level), coarse = albedoBetween(uv, min(level + 1, albedoLevels - 1));
    sum = sum + (fine + (coarse - fine) * part);
  }
  precise vec3 mean = sum * perTap;
  return mean;
}
