// The light that bloom scatters onto a pixel: level 0 has half the picture's size.
#include "draw/exact/screen/twice_as_large.glsl"
layout(binding = bloomUnit) uniform sampler2D scattered;

vec3 scatteredAt(ivec2 at) {
  ivec2 last = textureSize(scattered, 0) - 1;
  ivec2 a = clamp(ivec2(firstHalfTexel(at.x), firstHalfTexel(at.y)), ivec2(0), last);
  ivec2 b = clamp(ivec2(firstHalfTexel(at.x), firstHalfTexel(at.y)) + 1, ivec2(0), last);
  vec3 p = texelFetch(scattered, a, 0).rgb, q = texelFetch(scattered, ivec2(b.x, a.y), 0).rgb;
  vec3 r = texelFetch(scattered, ivec2(a.x, b.y), 0).rgb, s = texelFetch(scattered, b, 0).rgb;
  precise vec3 upper = p + (q - p) * secondWeight(at.x);
  precise vec3 lower = r + (s - r) * secondWeight(at.x);
  precise vec3 light = upper + (lower - upper) * secondWeight(at.y);
  return light;
}
