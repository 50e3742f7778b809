// Limits of screen-space reflections: max distance of reflected objects and max roughness of a mirror. Compiles as GLSL
// and as C++.
#ifndef EXACT_MIRROR_REACH
#define EXACT_MIRROR_REACH
#include "common/exact.glsl"
#ifndef MIRROR_TWIN
#include "common/once.glsl"
uniform vec2 mirrorReach;  // x: max length of rays (m); y: assumed thickness of objects (m)
vec2 mirrorReach_ = once(mirrorReach);
#endif

// Max roughness for which reflections have full weight, and min roughness for which they have none.
const float mirrorSmooth = 0.1f, mirrorRough = 0.3f;

// Returns the smoothstep 3 t^2 - 2 t^3, where t is x clamped to 0..1.
FUNCTION float easedBetween(float x) {
  float t = clamp(x, 0.0f, 1.0f);
  precise float eased = t * t * (3.0f - 2.0f * t);
  return eased;
}

// Returns the weight of reflections at the given roughness.
FUNCTION float smoothnessOf(float roughness) {
  precise float span = mirrorRough - mirrorSmooth;
  precise float rough = (roughness - mirrorSmooth) * exactReciprocal(span);
  precise float counts = 1.0f - easedBetween(rough);
  return counts;
}
#endif
