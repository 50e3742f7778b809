// Returns the fraction of ambient light that reaches a point. The fraction is the mean over the four half pixels around
// the point, weighted towards half pixels at a similar depth. Compiles as GLSL and as C++. The including file declares
// `view` and vec2 opennessAt(ivec2 half pixel), which returns openness and nearness.
#include "common/exact.glsl"
#include "draw/exact/occlusion/half_pixels.glsl"

FUNCTION float opennessOn(ivec2 pixel, vec3 p) {
  ivec2 own = ivec2(pixel.x >> 1, pixel.y >> 1), last = ivec2((view.size.x - 1) >> 1, (view.size.y - 1) >> 1);
  ivec2 aside = clamp(own + ivec2((pixel.x & 1) * 2 - 1, (pixel.y & 1) * 2 - 1), ivec2(0), last);
  precise vec3 from = p - vec3(view.eye);
  float depth = exactDot(from, vec3(view.forward));
  precise float open = 0.0f;
  precise float sum = 0.0f;
  for (int i = 0; i < 4; ++i) {
    ivec2 at = ivec2((i & 1) == 0 ? own.x : aside.x, i < 2 ? own.y : aside.y);
    vec2 found = opennessAt(at);
#ifdef PARALLEL
    precise float there = view.near + exactReciprocal(view.forward.w) - found.y;
    precise float off = (there - depth) * exactReciprocal(partOf(0.0f, 1.0f));
#else
    precise float off = found.y * depth - 1.0f;
#endif
    precise float near = 1.0f - 33.0f * abs(off);
    precise float like = max(near, 0.0f) + 1e-3f;
    precise float weight = like * ((i & 1) == 0 ? 0.75f : 0.25f) * (i < 2 ? 0.75f : 0.25f);
    open = open + found.x * weight;
    sum = sum + weight;
  }
  precise float mean = open * exactReciprocal(sum);
  return min(mean, 1.0f);
}
