// Functions for rules that supplement common/exact.glsl. Compiles as GLSL and as C++ (src/sim/reaction/rule/model.hpp).

// Rounds x to a multiple of 2^q by adding and subtracting `grain` = 1.5 * 2^(q + 23). This works if |x| is smaller than
// the grain, and avoids subnormal numbers, on which drivers disagree. A larger x loses only its last bits. -0 becomes
// 0. The grain is an argument, because compilers would fold literals.
FUNCTION float grained(float x, float grain) {
  precise float raised = x + grain;
  precise float rest = raised - grain;
  return rest;
}

// Returns tanh(x) with an error below 3e-7: an odd polynomial of degree 11 for |x| below 0.625 (Cephes, tanhf.c),
// otherwise 1 - 2 / (e^2x + 1).
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
