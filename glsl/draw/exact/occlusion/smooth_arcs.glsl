// What is lost, and what there were, summed along a row or a column of half pixels, of places on the plane of the middle one. The
// weights are those of a box of four and one more: a pattern of four half pixels leaves nothing behind, whether it grows or fades.
// Compiles as GLSL and as C++.
#include "draw/exact/occlusion/half_pixels.glsl"

// Of seven half pixels side by side, the middle one being number 3: both, and nearness, 0 outside the picture.
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

// The fraction of the surroundings' light that gets to a place.
FUNCTION float opennessOf(vec2 arcs) {
  precise float open = 1.0f - arcs.x * exactReciprocal(max(arcs.y, 1e-12f));
  return clamp(open, 0.0f, 1.0f);
}
