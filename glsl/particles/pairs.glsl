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
  y = y * ((2.38924456f - x * y * y) * 0.703952253f);
  precise float half_ = 0.5f * x;
  y = y * (1.50000036f - half_ * y * y);
  return y;
#endif
}

// Adds m d / (|d|^2 + eps^2)^(3/2), d from `here` to the body, w its mass (Plummer softening), without G.
FUNCTION vec3 addPull(vec3 sum, vec3 here, vec4 body, float softeningSquared) {
  precise vec3 d = vec3(body) - here;
#ifdef FAST_NUMERICS
  float squared = fma(d.z, d.z, fma(d.y, d.y, fma(d.x, d.x, softeningSquared)));  // one operation less
#else
  precise float squared = exactDot(d, d) + softeningSquared;
#endif
  float inverse = pairInverseSqrt(squared);
  precise vec3 total = sum + d * (inverse * inverse * inverse * body.w);
  return total;
}
