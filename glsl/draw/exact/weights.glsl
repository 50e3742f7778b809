// Where on a triangle a place of the picture (pixels) lies. Compiles as GLSL and as C++.
//
// A corner P = (x, y, 1) depth of the picture seen from the place q is P - q depth, a vector u of the plane; weights w with
// sum w_i u_i = 0 are those of the place on the triangle in space, so w_a = u_b x u_c and so on, over their sum.
#include "common/exact.glsl"

struct Weights {
  vec3 of;      // of the corners; not negative, of sum 1
  bool within;  // the place is on the triangle
  bool turned;  // the triangle is seen from behind
};

FUNCTION Weights weightsAt(vec3 a, vec3 b, vec3 c, vec2 place) {
  precise vec2 u = vec2(a) - place * a.z;
  precise vec2 v = vec2(b) - place * b.z;
  precise vec2 w = vec2(c) - place * c.z;
  precise float wa = v.x * w.y - v.y * w.x;
  precise float wb = w.x * u.y - w.y * u.x;
  precise float wc = u.x * v.y - u.y * v.x;
  Weights weights;
  precise float area = wa + wb + wc;
  weights.turned = area > 0.0f;
  wa = weights.turned ? wa : -wa;
  wb = weights.turned ? wb : -wb;
  wc = weights.turned ? wc : -wc;
  weights.within = min(wa, min(wb, wc)) >= 0.0f;
  wa = max(wa, 0.0f);
  wb = max(wb, 0.0f);
  wc = max(wc, 0.0f);
  precise float sum = wa + wb + wc;
  if (sum < 1e-25f) {
    weights.of = vec3(0.25f, 0.25f, 0.5f);
    return weights;
  }
  float perSum = exactReciprocal(sum);
  precise float x = wa * perSum;
  precise float y = wb * perSum;
  precise float z = wc * perSum;
  weights.of = vec3(x, y, z);
  return weights;
}
