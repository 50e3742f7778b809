// Reads a material's texture at a shading point of a surface (surface_seen.glsl). BUMPED: adds a relief whose height is
// the texture's brightness.
#include "common/once.glsl"
#include "draw/exact/surface/texture_read.glsl"
#include "draw/surface/raised_normal.glsl"
#ifdef BUMPED
uniform float bump;  // height of white in metres
float bump_ = once(bump);
#endif

// Colours of the texture at the pixel and at offsets of `aside` pixels to the right, left, above and below.
struct Patch {
  vec3 color;
#ifdef BUMPED
  float aside;
  vec3 right, left, above, below;
#endif
};

Patch noPatch() {
  Patch patch_;
  patch_.color = vec3(0);
#ifdef BUMPED
  patch_.aside = 1.0f;
  patch_.right = patch_.left = patch_.above = patch_.below = vec3(0);
#endif
  return patch_;
}

// Adds the colours of one projection, multiplied by its weight.
Patch withSide(Patch patch_, Seen seen, float weight) {
  precise vec3 color = patch_.color + weight * textureSeen(seen, vec2(0));
  patch_.color = color;
#ifdef BUMPED
  float aside = patch_.aside;
  precise vec3 right = patch_.right + weight * textureSeen(seen, vec2(aside, 0));
  precise vec3 left = patch_.left + weight * textureSeen(seen, vec2(-aside, 0));
  precise vec3 above = patch_.above + weight * textureSeen(seen, vec2(0, aside));
  precise vec3 below = patch_.below + weight * textureSeen(seen, vec2(0, -aside));
  patch_.right = right;
  patch_.left = left;
  patch_.above = above;
  patch_.below = below;
#endif
  return patch_;
}

#ifdef TRIPLANAR
// Loops only over the projections with a weight above 0, because software drivers execute both sides of a branch. Most
// walls and floors need only one projection.
Patch patchSeen(SurfaceSeen seen) {
  vec3 w = seen.weight;
  Patch sum = noPatch();
#ifdef BUMPED
  sum.aside = pixelsAside(exactDot(w, vec3(texelsAPixel(seen.x), texelsAPixel(seen.y), texelsAPixel(seen.z))));
#endif
  int left = sidesThatShow(w);
  while (left != 0) {
    int side = findLSB(left);
    left &= left - 1;
    sum = withSide(sum, sideSeen(seen, side), side == 0 ? w.x : side == 1 ? w.y : w.z);
  }
  return sum;
}
#else
Patch patchSeen(SurfaceSeen seen) {
  Patch sum = noPatch();
#ifdef BUMPED
  sum.aside = pixelsAside(texelsAPixel(seen));
#endif
  return withSide(sum, seen, 1.0f);
}
#endif

#ifdef BUMPED
vec3 bumpedNormal(Patch patch_, Spot spot, vec3 normal) {
  precise float perPixel = 0.5f * bump_ * exactReciprocal(patch_.aside);
  precise float across = brightness(patch_.right) - brightness(patch_.left);
  precise float up = brightness(patch_.above) - brightness(patch_.below);
  precise vec2 rises = vec2(across, up) * perPixel;
  precise vec3 right = planePlace(spot, vec2(1, 0)) - spot.place;
  precise vec3 above = planePlace(spot, vec2(0, -1)) - spot.place;
  return raisedNormal(normal, right, above, rises);
}
#endif
