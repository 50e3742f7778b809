// Pictures without a background: converts premultiplied light to straight alpha. Compiles as GLSL and as C++.
#include "draw/arithmetic.glsl"

// Returns the alpha of a pixel. Objects hide the fraction `covered` of the background. Added light (glows, bloom) hides
// the remaining part in proportion to its brightest channel, so that the pixel looks unchanged over black.
FUNCTION float coverOf(float covered, vec3 added) {
  float bright = clamp(max(added.x, max(added.y, added.z)), 0.0f, 1.0f);
  ROUNDED float cover = covered + (1.0f - covered) * bright;
  return clamp(cover, 0.0f, 1.0f);
}

// Returns the straight (not premultiplied) colour of a pixel that has the premultiplied `light` and the alpha `cover`.
FUNCTION vec3 lightOfCover(vec3 light, float cover) {
  if (cover < 1e-4f) return vec3(0.0f);
  ROUNDED vec3 own = light * inverse(cover);
  return own;
}

// Returns the part of the premultiplied `light` that counts as added light: all that exceeds a white surface of the
// alpha `covered`. `white`: light of a white surface.
FUNCTION vec3 lightBeyondCover(vec3 light, float covered, float white) {
  ROUNDED vec3 more = light - vec3(covered * white);
  return max(more, vec3(0.0f));
}

// Returns the straight colour of a pixel of the alpha `cover`, of which objects hide the fraction `covered`. `surface`:
// the encoded colour of the objects. `added`: the encoded added light alone, premultiplied.
FUNCTION vec3 colorOfCover(vec3 surface, float covered, vec3 added, float cover) {
  if (cover < 1e-4f) return vec3(0.0f);
  if (covered >= cover) return surface;
  ROUNDED float share = clamp(covered * inverse(cover), 0.0f, 1.0f);
  vec3 glow = lightOfCover(added, coverOf(0.0f, added));
  ROUNDED vec3 color = share * surface + (1.0f - share) * glow;
  return color;
}
