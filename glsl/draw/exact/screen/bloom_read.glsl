// Returns the bloom light of a pixel, interpolated from bloom level 0, which has half the picture's size.
#include "draw/exact/screen/twice_as_large.glsl"
LIGHT_PICTURE(bloomUnit, scatteredImage, scattered);

vec3 scatteredAt(ivec2 at) {
  ivec2 last = pictureSize(scattered) - 1;
  ivec2 a = clamp(ivec2(firstHalfTexel(at.x), firstHalfTexel(at.y)), ivec2(0), last);
  ivec2 b = clamp(ivec2(firstHalfTexel(at.x), firstHalfTexel(at.y)) + 1, ivec2(0), last);
  vec3 p = LIGHT_AT(scattered, a).rgb, q = LIGHT_AT(scattered, ivec2(b.x, a.y)).rgb;
  vec3 r = LIGHT_AT(scattered, ivec2(a.x, b.y)).rgb, s = LIGHT_AT(scattered, b).rgb;
  precise vec3 upper = p + (q - p) * secondWeight(at.x);
  precise vec3 lower = r + (s - r) * secondWeight(at.x);
  precise vec3 light = upper + (lower - upper) * secondWeight(at.y);
  return light;
}
