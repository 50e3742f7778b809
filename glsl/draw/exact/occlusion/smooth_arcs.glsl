// The mean of what is lost over 4x4 half pixels, those at the borders by half, of places on the plane of the middle one: it has each
// turn of horizons.glsl once. Compiles as GLSL and as C++. Whoever includes it has float nearnessAt(ivec2 half pixel), 0 outside
// the picture, and vec2 arcsAt(ivec2).
#include "draw/exact/occlusion/half_pixels.glsl"

// The fraction of the surroundings' light that gets to the place, from 0 to 1.
FUNCTION float opennessOf(ivec2 at, float here) {
  float left = nearnessAt(at - ivec2(1, 0)), right = nearnessAt(at + ivec2(1, 0));
  float above = nearnessAt(at - ivec2(0, 1)), below = nearnessAt(at + ivec2(0, 1));
  float across = slopeBetween(left, here, right), down = slopeBetween(above, here, below);
  precise float far = 0.03f * here;
  float perFar = exactReciprocal(max(far, 1e-12f));
  precise float lost = 0.0f;
  precise float all_ = 1e-12f;
  for (int y = -2; y <= 2; ++y)
    for (int x = -2; x <= 2; ++x) {
      ivec2 there = at + ivec2(x, y);
      vec2 arcs = arcsAt(there);
      precise float off = nearnessAt(there) - (here + (across * float(x) + down * float(y)));
      precise float near = 1.0f - abs(off) * perFar;
      precise float like = max(near, 0.0f) * (abs(x) == 2 ? 0.5f : 1.0f) * (abs(y) == 2 ? 0.5f : 1.0f);
      lost = lost + arcs.x * like;
      all_ = all_ + arcs.y * like;
    }
  precise float open = 1.0f - lost * exactReciprocal(all_);
  return clamp(open, 0.0f, 1.0f);
}
