// Size of a particle as a ball. Compiles as GLSL and as C++. The including file provides `stepData` (ParticleStep) and
// common/exact.glsl.

// Returns the factor on a ball's radius, and on the distance that it keeps from solids.
FUNCTION float ballScale(float mass) {
  if (stepData.balls.sizeExponent == 0.0f) return 1.0f;
  precise float masses = max(mass, 0.0f) * stepData.balls.perMassReference;
  return exactPow(masses, stepData.balls.sizeExponent);
}
