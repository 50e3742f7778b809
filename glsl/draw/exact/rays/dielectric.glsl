// Reflection and refraction at a smooth boundary between two clear media. `eta` is the index of refraction on the
// viewer's side divided by the index on the opposite side. Compiles as GLSL and as C++.
#ifndef EXACT_RAY_DIELECTRIC
#define EXACT_RAY_DIELECTRIC
#include "common/exact.glsl"

// Returns the fraction of unpolarized light that is reflected, by Fresnel's equations. The fraction is 1 for total
// internal reflection.
FUNCTION float dielectricFresnel(float cosine, float eta) {
  precise float sine2 = eta * eta * (1.0f - cosine * cosine);
  precise float under = 1.0f - sine2;
  float beyond = exactSqrt(max(under, 0.0f));
  precise float dense = eta * cosine;
  precise float thin = eta * beyond;
  precise float sum = dense + beyond;
  precise float other = cosine + thin;
  precise float across = (dense - beyond) * exactReciprocal(max(sum, 1e-20f));
  precise float along = (cosine - thin) * exactReciprocal(max(other, 1e-20f));
  precise float mirrored = 0.5f * (across * across + along * along);
  return under <= 0.0f ? 1.0f : min(mirrored, 1.0f);
}

// Returns the direction, refracted by Snell's law, from which light reaches the viewer. `view` and the result point
// away from the surface point. There must be no total internal reflection.
FUNCTION vec3 refractedDirection(vec3 view, vec3 normal, float eta) {
  float cosine = exactDot(view, normal);
  precise float under = 1.0f - eta * eta * (1.0f - cosine * cosine);
  precise float along = eta * cosine - exactSqrt(max(under, 0.0f));
  precise vec3 direction = normal * along - view * eta;
  return direction;
}
#endif
