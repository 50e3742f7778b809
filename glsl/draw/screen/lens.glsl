// The lens darkens towards the corners of the picture. Compiles as GLSL and as C++.
#include "draw/arithmetic.glsl"

// What the film gets of the light at the middle `aside` of a pixel, -1 to 1 over the picture.
FUNCTION vec3 throughLens(vec3 light, vec2 aside) {
  ROUNDED float dark = frame.vignette * 0.5f * (aside.x * aside.x + aside.y * aside.y);
  ROUNDED vec3 through = light * (frame.exposure * (1.0f - dark));
  return through;
}
