// Where on a triangle a place of the picture (pixels) lies. Compiles as GLSL and as C++.
//
// A corner P = (x, y, 1) depth of the picture seen from the place q is P - q depth, a vector u of the plane; weights w with
// sum w_i u_i = 0 are those of the place on the triangle in space, so w_a = u_b x u_c and so on, over their sum. PARALLEL: a corner is
// x, y and depth apart, seen from q at P - q.
#ifndef EXACT_WEIGHTS
#define EXACT_WEIGHTS
#include "common/exact.glsl"

struct Weights {
  vec3 of;      // of the corners; not negative, of sum 1
  bool within;  // the place is on the triangle
  bool turned;  // the triangle is seen from behind
};

// Where the place is outside, weights are negative.
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
