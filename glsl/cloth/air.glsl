// Air force on one corner of a cloth face. Compiles as GLSL and as C++. Needs `stepData` (ClothStep), and `blown` and
// windAt() of fluid/wind_array.glsl.

// Gusts are value noise with three components in [-1, 1). latticeVector() returns the random vector of a lattice point.
// noise() interpolates the vectors with the weights 3u^2 - 2u^3, where u is the position between two lattice points.
FUNCTION vec3 latticeVector(int x, int y, int z) {
  return signedUnits(hash3(uvec3(uint(x), uint(y), uint(z) ^ (uint(stepData.seed) * 0x9e3779b9u))));
}
FUNCTION vec3 latticeRow(int x, int y, int z, float t) {
  return exactMix(latticeVector(x, y, z), latticeVector(x + 1, y, z), t);
}

FUNCTION float smoothCurve(float u) {
  precise float t = (3.0f - 2.0f * u) * u * u;
  return t;
}

FUNCTION vec3 noise(vec3 p) {
  precise vec3 base = floor(p);
  precise vec3 u = p - base;
  int x = int(base.x);
  int y = int(base.y);
  int z = int(base.z);
  float tx = smoothCurve(u.x);
  float ty = smoothCurve(u.y);
  vec3 low = exactMix(latticeRow(x, y, z, tx), latticeRow(x, y + 1, z, tx), ty);
  vec3 high = exactMix(latticeRow(x, y, z + 1, tx), latticeRow(x, y + 1, z + 1, tx), ty);
  return exactMix(low, high, smoothCurve(u.z));
}

// Returns the air force on a corner of a face. c = a x b is twice the area vector of the triangle (here, a, b). A
// quarter of c belongs to this corner, so its area vector is A n = c / 4. With the velocity v of the air relative to
// the cloth:
//   drag = 1/2 rho Cd A |v.n| v,   lift = 1/2 rho Cl A (v.n) (|v|^2 n - (v.n) v) / |v|.
// The lift is perpendicular to v. It is zero if the face is edge-on or face-on to v.
FUNCTION vec3 airForceOnFace(vec3 a, vec3 b, vec3 v, float speedSquared, float inverseSpeed) {
  vec3 c = exactCross(a, b);
  float through = exactDot(v, c);
  precise float pressure = 0.125f * stepData.air.density;
  precise float drag = pressure * stepData.air.drag * abs(through);
  float inverseArea = exactInverseSqrt(max(exactDot(c, c), 1e-24f));
  precise float lift = pressure * stepData.air.lift * through * inverseSpeed * inverseArea;
  precise vec3 force = v * drag + (c * speedSquared - v * through) * lift;
  return force;
}
