// Gravity of one body on another. Compiles as GLSL and as C++.

// Returns 1/sqrt(x) for 1e-12 <= x <= 1e18 with a relative error below 5.1e-7. The constants of the first Newton step
// balance the error (J. Kadlec 2010), which is 6.5e-4 after that step. The second step is y' = y (3/2 - x y^2 / 2),
// where 3/2 is increased by half of the remaining error. The function needs a third fewer operations per pair than
// exactInverseSqrt(). The force still depends only on the distance, so its magnitude is the same for both bodies.
FUNCTION float pairInverseSqrt(float x) {
#ifdef FAST_NUMERICS
  return inversesqrt(x);
#else
  precise float y = intBitsToFloat(0x5f1ffff9 - (floatBitsToInt(x) >> 1));
  y = y * ((2.38924456f - x * y * y) * 0.703952253f);
  precise float half_ = 0.5f * x;
  y = y * (1.50000036f - half_ * y * y);
  return y;
#endif
}

// Adds m d / (|d|^2 + eps^2)^(3/2) to `sum`, without the factor G (Plummer softening). d is the vector from `here` to
// the body; w of `body` is its mass m.
FUNCTION vec3 addPull(vec3 sum, vec3 here, vec4 body, float softeningSquared) {
  precise vec3 d = vec3(body) - here;
#ifdef FAST_NUMERICS
  // fma needs one operation less than the exact form.
  float squared = fma(d.z, d.z, fma(d.y, d.y, fma(d.x, d.x, softeningSquared)));
#else
  precise float squared = exactDot(d, d) + softeningSquared;
#endif
  float inverse = pairInverseSqrt(squared);
  precise vec3 total = sum + d * (inverse * inverse * inverse * body.w);
  return total;
}
