// Clips a triangle to the near plane and to the guard band around the picture. A corner is a vec3: pixels to the right
// and down, times depth, and depth (m). Compiles as GLSL and as C++.
#ifndef EXACT_CLIP
#define EXACT_CLIP
#include "draw/exact/fixed.glsl"

// Returns a value that is not negative inside plane k. Plane 0 is the near plane, planes 1 to 4 are the sides of the
// guard band.
FUNCTION float insideOf(int k, vec3 v, vec2 size, float nearest) {
  precise float depth = v.z - nearest;
  precise float left = v.x + float(guardPixels) * v.z;
  precise float right = (size.x + float(guardPixels)) * v.z - v.x;
  precise float above = v.y + float(guardPixels) * v.z;
  precise float below = (size.y + float(guardPixels)) * v.z - v.y;
  return k == 0 ? depth : k == 1 ? left : k == 2 ? right : k == 3 ? above : below;
}

FUNCTION bool inside(vec3 v, vec2 size, float nearest) {
  bool all_ = true;
  for (int k = 0; k < 5; ++k) all_ = all_ && insideOf(k, v, size, nearest) >= 0.0f;
  return all_;
}

// Returns true if the triangle is completely beyond one side of the picture, or nearer than the near plane.
FUNCTION bool beside(vec3 a, vec3 b, vec3 c, vec2 size, float nearest) {
  precise vec3 x = size.x * vec3(a.z, b.z, c.z) - vec3(a.x, b.x, c.x);
  precise vec3 y = size.y * vec3(a.z, b.z, c.z) - vec3(a.y, b.y, c.y);
  return max(a.z, max(b.z, c.z)) < nearest || max(a.x, max(b.x, c.x)) < 0.0f || max(a.y, max(b.y, c.y)) < 0.0f ||
         max(x.x, max(x.y, x.z)) < 0.0f || max(y.x, max(y.y, y.z)) < 0.0f;
}

struct Polygon {
  vec3 corners[8];
  int count;
};

// Intersects an edge with a plane, always from the inner to the outer end, so that both triangles of an edge get the
// same point.
FUNCTION vec3 crossing(vec3 in_, vec3 out_, float here, float there) {
  precise float span = here - there;
  precise float t = here * exactReciprocal(max(span, 1e-30f));
  precise vec3 v = in_ + (out_ - in_) * t;
  return v;
}

FUNCTION Polygon clipped(Polygon whole, int k, vec2 size, float nearest) {
  Polygon part;
  part.count = 0;
  for (int i = 0; i < whole.count; ++i) {
    vec3 a = whole.corners[i], b = whole.corners[i + 1 < whole.count ? i + 1 : 0];
    float da = insideOf(k, a, size, nearest), db = insideOf(k, b, size, nearest);
    if (da >= 0.0f && part.count < 8) part.corners[part.count++] = a;
    if ((da >= 0.0f) != (db >= 0.0f) && part.count < 8)
      part.corners[part.count++] = da >= 0.0f ? crossing(a, b, da, db) : crossing(b, a, db, da);
  }
  return part;
}

FUNCTION Polygon clippedToPicture(vec3 a, vec3 b, vec3 c, vec2 size, float nearest) {
  Polygon p;
  p.corners[0] = a;
  p.corners[1] = b;
  p.corners[2] = c;
  p.count = 3;
  bool whole = inside(a, size, nearest) && inside(b, size, nearest) && inside(c, size, nearest);
  int planes = whole ? 0 : 5;
  for (int k = 0; k < planes; ++k) p = clipped(p, k, size, nearest);
  return p;
}
#endif
