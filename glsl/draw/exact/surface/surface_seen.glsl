// Texture coordinates of a surface's shading point and their changes per pixel: uv coordinates or, with TRIPLANAR,
// projections along the three axes of the surface's object space.
#include "common/once.glsl"
#include "draw/surface/footprint.glsl"
#include "draw/surface/three_sides.glsl"
uniform vec2 textureScale;  // repeats of the texture along u and v or, for triplanar projection, per metre
vec2 textureScale_ = once(textureScale);
#ifdef TRIPLANAR
uniform mat4 model;
mat4 model_ = once(model);
uniform float modelScale;  // length scale of the model matrix
float modelScale_ = once(modelScale);

// Returns the position in the surface's object space (m), for the weights w of the corners.
vec3 ownPlace(Spot spot, vec3 w) {
  precise vec3 mean = w.x * vertexPlace(spot.corners.x - firstVertex_) +
                      w.y * vertexPlace(spot.corners.y - firstVertex_) +
                      w.z * vertexPlace(spot.corners.z - firstVertex_);
  precise vec3 p = mean * modelScale_;
  return p;
}

struct SurfaceSeen {
  Seen x, y, z;
  vec3 weight;
  vec3 side;
};

Seen seenBetween(vec2 at, vec2 right, vec2 above) {
  Seen seen;
  precise vec2 here = at * textureScale_;
  precise vec2 across = (right - at) * textureScale_;
  precise vec2 up = (above - at) * textureScale_;
  seen.at = here;
  seen.across = across;
  seen.up = up;
  return seen;
}

SurfaceSeen surfaceSeen(Spot spot) {
  vec3 n = spot.normal;
  vec3 own = vec3(exactDot(model_[0].xyz, n), exactDot(model_[1].xyz, n), exactDot(model_[2].xyz, n));
  precise vec3 normal = own * exactReciprocal(modelScale_);
  ThreeSides here = threeSides(ownPlace(spot, spot.weight), normal);
  ThreeSides right = threeSides(ownPlace(spot, weightsBeside(spot, vec2(1, 0))), normal);
  ThreeSides above = threeSides(ownPlace(spot, weightsBeside(spot, vec2(0, -1))), normal);
  SurfaceSeen seen;
  seen.x = seenBetween(here.x, right.x, above.x);
  seen.y = seenBetween(here.y, right.y, above.y);
  seen.z = seenBetween(here.z, right.z, above.z);
  seen.weight = here.weight;
  seen.side = here.side;
  return seen;
}

// Returns a bit mask of the projections whose weight is above 0.
int sidesThatShow(vec3 weight) {
  return (weight.x > 0.0f ? 1 : 0) | (weight.y > 0.0f ? 2 : 0) | (weight.z > 0.0f ? 4 : 0);
}

Seen sideSeen(SurfaceSeen seen, int side) {
  Seen one = seen.z;
  if (side == 0) one = seen.x;
  if (side == 1) one = seen.y;
  return one;
}
#else
#include "draw/exact/surface/surface_uv.glsl"
#define SurfaceSeen Seen

SurfaceSeen surfaceSeen(Spot spot) {
  return seenByUv(spot, textureScale_);
}
#endif

// Returns the point of the triangle's plane that is visible at the pixel offset `aside`.
vec3 planePlace(Spot spot, vec2 aside) {
  precise vec2 at = spot.at + aside;
  return placeUnder(weightsBeside(spot, aside), spot.a.z, spot.b.z, spot.c.z, rayThrough(at));
}
