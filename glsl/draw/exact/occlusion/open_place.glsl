// Returns the fraction of ambient light that reaches a point. The fraction is the mean over the four half pixels around
// the point, weighted towards half pixels at a similar depth. If none of the four has a similar depth, as next to the
// edge of a near object, half pixels farther away count. Compiles as GLSL and as C++. The including file declares
// `view` and vec2 opennessAt(ivec2 half pixel), which returns openness and nearness.
#include "common/exact.glsl"
#include "draw/exact/occlusion/half_pixels.glsl"

// Returns the weight of a half pixel of the given nearness for a point at a depth: 1 at the same depth, 0 from 3% on.
FUNCTION float likeDepth(float nearness, float depth) {
#ifdef PARALLEL
  precise float there = view.near + exactReciprocal(view.forward.w) - nearness;
  precise float off = (there - depth) * exactReciprocal(partOf(0.0f, 1.0f));
#else
  precise float off = nearness * depth - 1.0f;
#endif
  precise float near = 1.0f - 33.0f * abs(off);
  return max(near, 0.0f);
}

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
    precise float like = likeDepth(found.y, depth) + 1e-3f;
    precise float weight = like * ((i & 1) == 0 ? 0.75f : 0.25f) * (i < 2 ? 0.75f : 0.25f);
    open = open + found.x * weight;
    sum = sum + weight;
  }
  for (int i = sum < 0.02f ? 0 : 8; i < 8; ++i) {
    int side = (i & 2) - 1;
    ivec2 diagonal = ivec2((i & 1) * 2 - 1, side), straight = (i & 1) == 0 ? ivec2(2 * side, 0) : ivec2(0, 2 * side);
    vec2 found = opennessAt(clamp(own + (i < 4 ? straight : diagonal), ivec2(0), last));
    float like = likeDepth(found.y, depth);
    open = open + found.x * like;
    sum = sum + like;
  }
  precise float mean = open * exactReciprocal(sum);
  return min(mean, 1.0f);
}
