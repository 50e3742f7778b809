// Pictures without a background: light over nothing as straight alpha. Compiles as GLSL and as C++.
#include "draw/arithmetic.glsl"

// How much of what lies behind a pixel is hidden. Things hide the part `covered` of it; light that is only added (glows, what is
// scattered) hides the more of the rest the brighter its brightest channel is shown: over black it looks as it does alone.
FUNCTION float coverOf(float covered, vec3 added) {
  float bright = clamp(max(added.x, max(added.y, added.z)), 0.0f, 1.0f);
  ROUNDED float cover = covered + (1.0f - covered) * bright;
  return clamp(cover, 0.0f, 1.0f);
}

// What the part that is hidden has of what the pixel has in all.
FUNCTION vec3 lightOfCover(vec3 light, float cover) {
  if (cover < 1e-4f) return vec3(0.0f);
  ROUNDED vec3 own = light * inverse(cover);
  return own;
}
