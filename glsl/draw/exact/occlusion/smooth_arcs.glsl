// Sums the occluded and the total light along a row or column of half pixels, over the neighbours that are on the plane
// of the middle one. The weights are a box of four convolved with itself. A pattern with a period of four half pixels
// therefore vanishes, even if its amplitude changes. Compiles as GLSL and as C++.
#include "draw/exact/occlusion/half_pixels.glsl"

// Seven adjacent half pixels; the middle one has index 3. Each has occluded light, total light and nearness (0 outside
// the picture).
struct ArcsBeside {
  vec3 of[7];
};

FUNCTION vec2 smoothArcs(ArcsBeside seen) {
  float here = seen.of[3].z;
  float slope = slopeBetween(seen.of[2].z, here, seen.of[4].z);
  float far = partOf(here, 0.03f);
  float perFar = exactReciprocal(max(far, 1e-12f));
  precise float lost = 0.0f;
  precise float all_ = 0.0f;
  for (int k = -3; k <= 3; ++k) {
    vec3 there = seen.of[k + 3];
    precise float off = there.z - (here + slope * float(k));
    precise float near = 1.0f - abs(off) * perFar;
    precise float like = max(near, 0.0f) * float(4 - abs(k));
    lost = lost + there.x * like;
    all_ = all_ + there.y * like;
  }
  return vec2(lost, all_);
}

// Returns the fraction of ambient light that reaches a point.
FUNCTION float opennessOf(vec2 arcs) {
  precise float open = 1.0f - arcs.x * exactReciprocal(max(arcs.y, 1e-12f));
  return clamp(open, 0.0f, 1.0f);
}
