// Barycentric weights of a picture position (pixels) on a triangle. Compiles as GLSL and as C++.
// A projected corner is P = (x depth, y depth, depth). Relative to the picture position q, it is the 2D vector u = P.xy
// - q depth. Weights w with sum w_i u_i = 0 give the point of the triangle in space, so w_a = u_b x u_c and so on,
// divided by the sum of the weights. PARALLEL: a corner has x, y and a separate depth; relative to q it is P.xy - q.
#ifndef EXACT_WEIGHTS
#define EXACT_WEIGHTS
#include "common/exact.glsl"

struct Weights {
  vec3 of;      // barycentric weights of the corners, not negative, with sum 1
  bool within;  // true if the triangle covers the picture position
  bool turned;  // true if the triangle's back side is visible
};

// Returns weights that are not normalized. Outside the triangle, some weights have the opposite sign.
FUNCTION vec3 weightsAround(vec3 a, vec3 b, vec3 c, vec2 place) {
#ifdef PARALLEL
  precise vec2 u = vec2(a) - place;
  precise vec2 v = vec2(b) - place;
  precise vec2 w = vec2(c) - place;
#else
  precise vec2 u = vec2(a) - place * a.z;
  precise vec2 v = vec2(b) - place * b.z;
  precise vec2 w = vec2(c) - place * c.z;
#endif
  precise float wa = v.x * w.y - v.y * w.x;
  precise float wb = w.x * u.y - w.y * u.x;
  precise float wc = u.x * v.y - u.y * v.x;
  return vec3(wa, wb, wc);
}

FUNCTION vec3 ofSumOne(vec3 w) {
  precise float sum = w.x + w.y + w.z;
  if (abs(sum) < 1e-25f) return vec3(0.25f, 0.25f, 0.5f);
  precise vec3 part = w * exactReciprocal(sum);
  return part;
}

FUNCTION Weights weightsAt(vec3 a, vec3 b, vec3 c, vec2 place) {
  vec3 w = weightsAround(a, b, c, place);
  precise float area = w.x + w.y + w.z;
  Weights weights;
  weights.turned = area > 0.0f;
  w = weights.turned ? w : -w;
  weights.within = min(w.x, min(w.y, w.z)) >= 0.0f;
  weights.of = ofSumOne(max(w, vec3(0)));
  return weights;
}
#endif
