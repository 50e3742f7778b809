// One step of Gray-Scott in one cell, only additions, multiplications and comparisons. Compiles as GLSL and
// as C++ (src/sim/gray_scott/plan.hpp).
//
//   u' = u + dt (Du lap(u) - u v^2 + F (1 - u)),   v' = v + dt (Dv lap(v) + u v^2 - (F + k) v)
//
// lap: edge neighbours 0.2, corners 0.05, centre -1, on a torus.
// a b + c where the product is exact: the same bits in one instruction as in two.
#ifdef __cplusplus
#define PLUS_EXACT_PRODUCT(a, b, c) ((a) * (b) + (c))
#else
#define PLUS_EXACT_PRODUCT(a, b, c) fma(a, b, c)
#endif

// What each step is told.
struct STD140 GrayScottRates {
  float diffuseU;  // dt Du / 20
  float diffuseV;  // dt Dv / 20
  float feed;      // dt F
  float kill;      // dt k
  float dt;
  float feedSpan;  // what a weight of 1 adds to the feed
  float killSpan;
};

// 20 lap = 4 edges + corners - 20 centre, from sums of the four neighbours each. Exactly zero where all nine
// are equal.
FUNCTION float laplacian20(float centre, float edges, float corners) {
  precise float sum = PLUS_EXACT_PRODUCT(4.0f, edges, corners) - 20.0f * centre;
  return sum;
}

// dt u v^2
FUNCTION float reaction(float u, float v, float dt) {
  precise float reacted = u * v * v * dt;
  return reacted;
}

// Within [0, 1]; what is below 1e-20 becomes zero, so that no product here is a subnormal number that a sum
// would show: drivers disagree on those.
FUNCTION float heldToUnit(float x) {
  float clamped = min(x, 1.0f);
  return clamped < 1e-20f ? 0.0f : clamped;
}

// Before it is held to [0, 1].
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

// A rate that varies over the grid: weight 0 is `base`, weight 1 is base + span.
FUNCTION float mappedRate(float base, float span, float weight) {
  precise float rate = base + span * weight;
  return rate;
}
