// The relief that a texture's brightness makes. Compiles as GLSL and as C++.
#include "draw/arithmetic.glsl"

FUNCTION float brightness(vec3 color) {
  return dotted(color, vec3(0.2126f, 0.7152f, 0.0722f));
}

// The normal n of the surface raised by a height: n - grad height, from its changes over a pixel (Mikkelsen, "Bump Mapping
// Unparametrized Surfaces on the GPU", 2010). `across` and `up`: how the place changes over a pixel to the right and up;
// `rises`: how the height does (m).
FUNCTION vec3 raisedNormal(vec3 normal, vec3 across, vec3 up, vec2 rises) {
  vec3 first = crossed(up, normal), second = crossed(normal, across);
  float area = dotted(across, first);
  ROUNDED vec3 rise = (area < 0.0f ? -1.0f : 1.0f) * (rises.x * first + rises.y * second);
  ROUNDED vec3 raised = abs(area) * normal - rise;
  return unitOf(raised);
}

// Half the pixels between the two places whose difference is the change over a pixel: the texture is linear between
// texels, and its slope jumps at each of them, so it is taken over a texel where that is more.
FUNCTION float pixelsAside(float texelsAPixel) {
  ROUNDED float aside = 0.5f * inverse(clamp(texelsAPixel, 0.02f, 1.0f));
  return aside;
}
