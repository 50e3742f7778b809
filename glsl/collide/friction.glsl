// Coulomb friction. Compiles as GLSL and as C++. Needs common/exact.glsl.

// Returns the fraction of the sliding vector that remains if friction removes at most the length `maximum` from it: max(0,
// 1 - most / |slide|).
FUNCTION float leftByFriction(vec3 slide, float maximum) {
  precise float part = maximum * exactInverseSqrt(max(exactDot(slide, slide), 1e-24f));
  precise float left = 1.0f - min(part, 1.0f);
  return left;
}
