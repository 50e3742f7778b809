// Lens effects: exposure and vignette (darkening towards the corners). WHITE_BALANCE: also applies the white balance.
// Compiles as GLSL and as C++.
#include "draw/arithmetic.glsl"

// Returns the light that reaches the film. `aside` is the position of the pixel's centre, -1 to 1 across the picture.
FUNCTION vec3 throughLens(vec3 light, vec2 aside) {
  ROUNDED float dark = frame.vignette * 0.5f * (aside.x * aside.x + aside.y * aside.y);
  ROUNDED vec3 through = light * (frame.exposure * (1.0f - dark));
#ifdef WHITE_BALANCE
  ROUNDED vec3 balanced = vec3(frame.whiteRed) * through.x + vec3(frame.whiteGreen) * through.y + vec3(frame.whiteBlue) * through.z;
  through = max(balanced, 0.0f);
#endif
  return through;
}
