// Closest points of triangles and segments. Compiles as GLSL and as C++, after common/exact.glsl.

// Closest point on a triangle a, b, c to a point p (Ericson 2005, 5.1.5).
struct Closest {
  vec3 offset;   // Vector from the closest point to p, m
  float squared;
  float v, w;    // Barycentric weights of b and c
  int feature;   // Location of the closest point: 0 inside; 1, 2, 3 on the edges ab, bc, ca; 4, 5, 6 at the corners a,
                 // b, c
};

FUNCTION Closest closestOf(vec3 p, vec3 a, vec3 b, vec3 c) {
  precise vec3 ab = b - a;
  precise vec3 ac = c - a;
  precise vec3 ap = p - a;
  precise vec3 bp = p - b;
  precise vec3 cp = p - c;
  float d1 = exactDot(ab, ap), d2 = exactDot(ac, ap);
  float d3 = exactDot(ab, bp), d4 = exactDot(ac, bp);
  float d5 = exactDot(ab, cp), d6 = exactDot(ac, cp);
  precise float va = d3 * d6 - d5 * d4;
  precise float vb = d5 * d2 - d1 * d6;
  precise float vc = d1 * d4 - d3 * d2;
  precise float toB = d4 - d3;
  precise float toC = d5 - d6;
  precise float sum = va + vb + vc;
  int feature = 0;
  if (va <= 0.0f && toB >= 0.0f && toC >= 0.0f) feature = 2;
  if (vb <= 0.0f && d2 >= 0.0f && d6 <= 0.0f) feature = 3;
  if (d6 >= 0.0f && d5 <= d6) feature = 6;
  if (vc <= 0.0f && d1 >= 0.0f && d3 <= 0.0f) feature = 1;
  if (d3 >= 0.0f && d4 <= d3) feature = 5;
  if (d1 <= 0.0f && d2 <= 0.0f) feature = 4;
  precise float alongAB = d1 - d3;
  precise float alongBC = toB + toC;
  precise float alongCA = d2 - d6;
  float whole = feature == 1 ? alongAB : feature == 2 ? alongBC : feature == 3 ? alongCA : sum;
  float inverse = exactReciprocal(max(whole, 1e-30f));
  float first = feature == 1 ? d1 : feature == 2 ? toC : vb;
  float second = feature == 2 ? toB : feature == 3 ? d2 : vc;
  precise float v = first * inverse;
  precise float w = second * inverse;
  v = feature == 5 ? 1.0f : feature == 3 || feature == 4 || feature == 6 ? 0.0f : v;
  w = feature == 6 ? 1.0f : feature == 1 || feature == 4 || feature == 5 ? 0.0f : w;
  precise vec3 offset = ap - ab * v - ac * w;
  Closest closest;
  closest.offset = offset;
  closest.squared = exactDot(offset, offset);
  closest.v = v;
  closest.w = w;
  closest.feature = feature;
  return closest;
}

// Parameters of the closest points of the segments a-b and c-d (Ericson 2005, 5.1.9). The argument `perSquared` is
// 1/|d-c|^2, or 0 if c-d is a point. For parallel segments, the search starts at the middle of a-b.
struct Crossing {
  float onFirst, onSecond;
};

FUNCTION Crossing crossingOf(vec3 a, vec3 b, vec3 c, vec3 d, float perSquared) {
  precise vec3 first = b - a;
  precise vec3 second = d - c;
  precise vec3 between = a - c;
  float ff = exactDot(first, first), fs = exactDot(first, second), ss = exactDot(second, second);
  float fb = exactDot(first, between), sb = exactDot(second, between);
  precise float whole = ff * ss - fs * fs;
  precise float minimum = ff * ss * 1e-6f;
  precise float share = (fs * sb - fb * ss) * exactReciprocal(max(whole, 1e-30f));
  float s = whole > minimum ? clamp(share, 0.0f, 1.0f) : 0.5f;
  precise float along = (fs * s + sb) * perSquared;
  float t = clamp(along, 0.0f, 1.0f);
  precise float back = (fs * t - fb) * exactReciprocal(max(ff, 1e-30f));
  Crossing crossing;
  crossing.onFirst = along < 0.0f || along > 1.0f || perSquared == 0.0f ? clamp(back, 0.0f, 1.0f) : s;
  crossing.onSecond = t;
  return crossing;
}
