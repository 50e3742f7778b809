// Gravity of one body on another. Compiles as GLSL and as C++.

// Adds m d / (|d|^2 + eps^2)^(3/2), d from `here` to the body, w its mass (Plummer softening; SPEC 2 without G).
FUNCTION vec3 addPull(vec3 sum, vec3 here, vec4 body, float softeningSquared) {
  precise vec3 d = vec3(body) - here;
  precise float xx = d.x * d.x;
  precise float yy = d.y * d.y;
  precise float zz = d.z * d.z;
  precise float squared = xx + yy;
  squared = squared + zz;
  squared = squared + softeningSquared;
#ifdef FAST_NUMERICS
  float inverse = inversesqrt(squared);
#else
  float inverse = exactInverseSqrt(squared);
#endif
  precise float cube = inverse * inverse;
  cube = cube * inverse;
  cube = cube * body.w;
  precise vec3 pull = d * cube;
  precise vec3 total = sum + pull;
  return total;
}
