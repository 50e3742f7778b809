// One Gray-Scott step in one cell, with additions, multiplications and comparisons only. Compiles as GLSL and as C++
// (src/sim/gray_scott/plan.hpp).
//
//  u' = u + dt (Du lap(u) - u v^2 + F (1 - u)),   v' = v + dt (Dv lap(v) + u v^2 - (F + k) v)
//
// Du and Dv are the diffusion rates, F the feed rate and k the kill rate. lap has the weights 0.2 for edge neighbours,
// 0.05 for corners and -1 for the centre, on a torus.

// Computes a b + c for an exact product, for which fma and separate operations give the same bits.
#ifdef __cplusplus
#define PLUS_EXACT_PRODUCT(a, b, c) ((a) * (b) + (c))
#else
#define PLUS_EXACT_PRODUCT(a, b, c) fma(a, b, c)
#endif

// Parameters of a step.
struct STD140 GrayScottRates {
  float diffuseU;  // dt times the diffusion rate of u, divided by 20
  float diffuseV;  // dt times the diffusion rate of v, divided by 20
  float feed;      // dt times the feed rate F
  float kill;      // dt times the kill rate k
  float dt;
  float feedSpan;  // Increase of `feed` for a weight of 1
  float killSpan;
};

// Returns 20 lap = 4 edges + corners - 20 centre, where `edges` and `corners` are the sums of the four neighbours of
// each kind. The result is exactly zero if all nine values are equal.
FUNCTION float laplacian20(float centre, float edges, float corners) {
  precise float sum = PLUS_EXACT_PRODUCT(4.0f, edges, corners) - 20.0f * centre;
  return sum;
}

// Returns dt u v^2.
FUNCTION float reaction(float u, float v, float dt) {
  precise float reacted = u * v * v * dt;
  return reacted;
}

// Clamps to [0, 1] and replaces values below 1e-20 by zero, so that no product becomes subnormal, because drivers
// disagree on subnormal numbers.
FUNCTION float heldToUnit(float x) {
  float clamped = min(x, 1.0f);
  return clamped < 1e-20f ? 0.0f : clamped;
}

// Return the next value without the clamp to [0, 1].
FUNCTION float freeU(float u, float laplacian, float reacted, GrayScottRates rates) {
  precise float next = u + (rates.diffuseU * laplacian - reacted + rates.feed * (1.0f - u));
  return next;
}

FUNCTION float freeV(float v, float laplacian, float reacted, GrayScottRates rates) {
  precise float next = v + (rates.diffuseV * laplacian + reacted - (rates.feed + rates.kill) * v);
  return next;
}

FUNCTION float nextU(float u, float laplacian, float reacted, GrayScottRates rates) {
  return heldToUnit(freeU(u, laplacian, reacted, rates));
}

FUNCTION float nextV(float v, float laplacian, float reacted, GrayScottRates rates) {
  return heldToUnit(freeV(v, laplacian, reacted, rates));
}

// Returns a rate that varies over the grid: `base` for the weight 0, base + span for the weight 1.
FUNCTION float mappedRate(float base, float span, float weight) {
  precise float rate = base + span * weight;
  return rate;
}
