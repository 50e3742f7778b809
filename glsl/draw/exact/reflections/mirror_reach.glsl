// How far away what is mirrored may be, and how smooth a mirror has to be for it. Compiles as GLSL and as C++.
#ifndef EXACT_MIRROR_REACH
#define EXACT_MIRROR_REACH
#include "common/exact.glsl"
#ifndef MIRROR_TWIN
#include "common/once.glsl"
uniform vec2 mirrorReach;  // m: how far rays go, and how thick things are
vec2 mirrorReach_ = once(mirrorReach);
#endif

const float mirrorSmooth = 0.1f, mirrorRough = 0.3f;  // roughness: all and nothing of what is met counts

// 3 t^2 - 2 t^3 of what lies between 0 and 1.
FUNCTION float easedBetween(float x) {
  float t = clamp(x, 0.0f, 1.0f);
  precise float eased = t * t * (3.0f - 2.0f * t);
  return eased;
}

// How much what is met counts with the roughness.
FUNCTION float smoothnessOf(float roughness) {
  precise float span = mirrorRough - mirrorSmooth;
  precise float rough = (roughness - mirrorSmooth) * exactReciprocal(span);
  precise float counts = 1.0f - easedBetween(rough);
  return counts;
}
#endif
