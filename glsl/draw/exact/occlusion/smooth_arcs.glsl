// What is lost, and what there were, summed along a row or a column of half pixels, of places on the plane of the middle one. The
// weights are those of a box of four and one more: a pattern of four half pixels leaves nothing behind, whether it grows or fades.
// Compiles as GLSL and as C++. Whoever includes it has vec4 arcsAt(ivec2 half pixel): both, and nearness, 0 outside the picture.
#include "draw/exact/occlusion/half_pixels.glsl"

FUNCTION vec2 smoothArcs(ivec2 at, ivec2 along) {
  float before = arcsAt(at - along).z, here = arcsAt(at).z, behind = arcsAt(at + along).z;
  float slope = slopeBetween(before, here, behind);
  float far = partOf(here, 0.03f);
  float perFar = exactReciprocal(max(far, 1e-12f));
  precise float lost = 0.0f;
  precise float all_ = 0.0f;
  for (int k = -3; k <= 3; ++k) {
    vec4 there = arcsAt(at + along * k);
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
