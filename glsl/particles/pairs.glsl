// Gravity of one body on another. Compiles as GLSL and as C++.

// 1/sqrt(x) for 1e-12 <= x <= 1e18, relative error below 5.1e-7: a first Newton step whose constants spread
// the error evenly (J. Kadlec 2010; 6.5e-4 after it), then y' = y (3/2 - x y^2 / 2) with 3/2 raised by half the
// error that is left. A third cheaper per pair than exactInverseSqrt, and gravity is still a function of
// the distance alone, the same for both bodies.
FUNCTION float pairInverseSqrt(float x) {
#ifdef FAST_NUMERICS
  return inversesqrt(x);
#else
  precise float y = intBitsToFloat(0x5f1ffff9 - (floatBitsToInt(x) >> 1));
  precise float t = x * y;
  t = t * y;
  t = 2.38924456f - t;
  t = t * 0.703952253f;
  y = y * t;
  precise float half_ = 0.5f * x;
  t = half_ * y;
  t = t * y;
  t = 1.50000036f - t;
  y = y * t;
  return y;
#endif
}

// Adds m d / (|d|^2 + eps^2)^(3/2), d from `here` to the body, w its mass (Plummer softening; SPEC 2 without G).
FUNCTION vec3 addPull(vec3 sum, vec3 here, vec4 body, float softeningSquared) {
  precise vec3 d = vec3(body) - here;
  precise float xx = d.x * d.x;
  precise float yy = d.y * d.y;
  precise float zz = d.z * d.z;
#ifdef FAST_NUMERICS
  float squared = fma(d.z, d.z, fma(d.y, d.y, fma(d.x, d.x, softeningSquared)));  // one operation less
#else
  precise float squared = xx + yy;
  squared = squared + zz;
  squared = squared + softeningSquared;
#endif
  float inverse = pairInverseSqrt(squared);
  precise float cube = inverse * inverse;
  cube = cube * inverse;
  cube = cube * body.w;
  precise vec3 pull = d * cube;
  precise vec3 total = sum + pull;
  return total;
}
