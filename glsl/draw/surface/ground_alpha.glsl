// Opacity of the ground, which fades out far from the camera's target. Compiles as GLSL and as C++.
#ifndef DRAW_GROUND_ALPHA
#define DRAW_GROUND_ALPHA
#include "draw/arithmetic.glsl"

FUNCTION float groundAlpha(vec3 p) {
  ROUNDED vec3 aside = p - vec3(frame.target);
  ROUNDED float distance2 = aside.x * aside.x + aside.z * aside.z;
  ROUNDED float far = (root(distance2) - frame.groundFadeStart) * frame.perGroundFade;
  ROUNDED float alpha = 1.0f - smoothed(clamp(far, 0.0f, 1.0f));
  return alpha;
}
#endif
