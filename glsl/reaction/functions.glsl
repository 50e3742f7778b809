// What rules are computed with besides common/exact.glsl. Compiles as GLSL and as C++ (src/sim/reaction/rule/model.hpp).

// Adding and taking away `grain`, 1.5 * 2^(q + 23), leaves a multiple of 2^q where x is smaller, whatever drivers do with
// subnormal numbers. What is greater keeps its bits but for the last, near that number. -0 becomes 0. A grain is told, since
// compilers add up literals.
FUNCTION float grained(float x, float grain) {
  precise float raised = x + grain;
  precise float rest = raised - grain;
  return rest;
}

// tanh(x), error below 3e-7: an odd polynomial of degree 11 below 0.625 (Cephes, tanhf.c), else 1 - 2 / (e^2x + 1).
FUNCTION float exactTanh(float x) {
  float a = min(abs(x), 20.0f);
  precise float s = a * a;
  precise float p = ((s * -5.7049887e-3f + 2.0639089e-2f) * s - 5.3739716e-2f) * s + 1.3331442e-1f;
  precise float low = (p * s - 3.3333282e-1f) * s * a + a;
  precise float twice = a + a;
  precise float beyond = exactExp(twice) + 1.0f;
  precise float high = 1.0f - 2.0f * exactReciprocal(beyond);
  float t = a < 0.625f ? low : high;
  return x < 0.0f ? -t : t;
}
