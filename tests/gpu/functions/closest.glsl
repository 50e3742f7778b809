#include "collide/closest.glsl"

FUNCTION vec4 asked(int i) {
  vec3 a = somePlace(i, 0), b = somePlace(i, 1), c = somePlace(i, 2), d = somePlace(i, 3);
  if (i % 3 != 0) {
    Closest found = closestOf(a, b, c, d);
    return vec4(found.squared, found.v, found.w, float(found.feature));
  }
  precise vec3 way = d - c;
  float square = exactDot(way, way);
  Crossing crossing = crossingOf(a, b, c, d, square > 0.0f ? exactReciprocal(square) : 0.0f);
  return vec4(crossing.onFirst, crossing.onSecond, 0.0f, 0.0f);
}
