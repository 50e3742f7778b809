// Bump mapping from a texture's brightness. Compiles as GLSL and as C++.
#include "draw/arithmetic.glsl"

FUNCTION float brightness(vec3 color) {
  return dotted(color, vec3(0.2126f, 0.7152f, 0.0722f));
}

// Returns the normal of a surface that is raised by a height: n - grad height, computed from changes per pixel
// (Mikkelsen, "Bump Mapping Unparametrized Surfaces on the GPU", 2010). `across` and `up` are the changes of the
// position per pixel to the right and up. `rises` holds the changes of the height (m).
FUNCTION vec3 raisedNormal(vec3 normal, vec3 across, vec3 up, vec2 rises) {
  vec3 first = crossed(up, normal), second = crossed(normal, across);
  float area = dotted(across, first);
  ROUNDED vec3 rise = (area < 0.0f ? -1.0f : 1.0f) * (rises.x * first + rises.y * second);
  ROUNDED vec3 raised = abs(area) * normal - rise;
  return unitOf(raised);
}

// Returns half the distance (pixels) between the two samples of a height difference. The distance is a whole texel for
// magnified textures, because they are linear between texels and their slope jumps at each texel.
FUNCTION float pixelsAside(float texelsAPixel) {
  ROUNDED float aside = 0.5f * inverse(clamp(texelsAPixel, 0.02f, 1.0f));
  return aside;
}
