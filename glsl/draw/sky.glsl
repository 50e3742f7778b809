// Sky radiance as a gradient over the height y of a unit direction, and the ambient light of the sky. ENVIRONMENT: a
// panoramic image replaces the gradient. Compiles as GLSL and as C++.
#ifndef DRAW_SKY
#define DRAW_SKY
#include "draw/arithmetic.glsl"
#ifdef ENVIRONMENT
#include "draw/environment_read.glsl"
#include "draw/environment.glsl"
#endif

FUNCTION vec3 skyRadiance(float y) {
  ROUNDED float up = 1.0f - clamp(y, 0.0f, 1.0f);
  ROUNDED float up2 = up * up;
  ROUNDED float up6 = up2 * up2 * up2;
  ROUNDED float below = -3.0f * y;
  vec3 above = blend(vec3(frame.zenith), vec3(frame.horizon), up6);
  return blend(above, vec3(frame.nadir), smoothed(clamp(below, 0.0f, 1.0f)));
}

// Returns the sky's radiance in a unit direction, including the glow around the sun: a cos^16 lobe.
FUNCTION vec3 skyInDirection(vec3 direction) {
#ifdef ENVIRONMENT
  return environmentAt(direction, 0);
#else
  ROUNDED float glow = max(dotted(direction, vec3(frame.sunDirection)), 0.0f);
  glow = glow * glow;
  glow = glow * glow;
  glow = glow * glow;
  glow = glow * glow;
  ROUNDED vec3 light = skyRadiance(direction.y) + vec3(frame.sunLight) * (frame.sunGlow * glow);
  return light;
#endif
}

// Returns irradiance / pi of the gradient sky on a surface. The argument is the y component of the surface's normal.
FUNCTION vec3 ambientLight(float y) {
  vec3 side = vec3(frame.ambientSide);
  ROUNDED vec3 light = side + max(y, 0.0f) * (vec3(frame.ambientUp) - side) +
                       max(-y, 0.0f) * (vec3(frame.ambientDown) - side);
  return light;
}

// Returns irradiance / pi of the sky (gradient or panoramic image) on a surface with the given normal.
FUNCTION vec3 ambientOn(vec3 normal) {
#ifdef ENVIRONMENT
  ROUNDED vec3 light = environmentAmbient(normal) * frame.ambient;
  return light;
#else
  return ambientLight(normal.y);
#endif
}

// Returns the sky radiance that a surface of the given roughness reflects. `direction` is the mirror direction of the
// view.
FUNCTION vec3 skyMirrored(vec3 direction, float roughness) {
#ifdef ENVIRONMENT
  return environmentMirrored(direction, roughness);
#else
  return blend(skyRadiance(direction.y), ambientLight(direction.y), roughness);
#endif
}
#endif
