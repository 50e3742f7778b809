// Lenia and SmoothLife: the change of a cell, computed from weighted sums over its neighbourhood. Compiles as GLSL and
// as C++ (tests/reference/lenia_twin.cpp).

// Growth function of a kernel, centred at mu with the width sigma. `kind` is 0 for polynomial, 1 for Gaussian, 2 for
// step; `weight` is the kernel's weight.
struct LeniaGrowth {
  float mu;
  float perSigma2;  // 1 / (9 sigma^2) for the polynomial, 1 / (2 sigma^2) for the Gaussian, sigma for the step
  float weight;
  int kind;
};

// Returns the growth, -1 to 1, of the weighted sum u, with d = u - mu. Polynomial: 2 max(0, 1 - d^2 / (9 sigma^2))^4 -
// 1. Gaussian: 2 exp(-d^2 / (2 sigma^2)) - 1. Step: 1 if |d| <= sigma, otherwise -1.
FUNCTION float leniaGrowth(LeniaGrowth g, float u) {
  precise float d = u - g.mu;
  precise float part = d * d * g.perSigma2;
  precise float left = 1.0f - part;
  float base = max(left, 0.0f);
  precise float square = base * base;
  precise float fourth = square * square;
  float bell = fourth;
  precise float power = 0.0f - part;
  if (g.kind == 1) bell = exactExp(power);
  if (g.kind == 2) bell = abs(d) <= g.perSigma2 ? 1.0f : 0.0f;
  precise float growth = 2.0f * bell - 1.0f;
  return growth;
}

// Returns 1 / (1 + exp(-(x - a) slope)).
FUNCTION float smoothStepAt(float x, float a, float slope) {
  precise float power = (a - x) * slope;
  precise float under = 1.0f + exactExp(power);
  return exactReciprocal(under);
}

// Returns SmoothLife's transition from the fillings n of the ring and m of the disc (0 to 1). A cell is born if n is
// between b.x and b.y, and survives if n is between b.z and b.w; m interpolates between the two intervals. slopeN and
// slopeM are the slopes 4 / alpha for n and for m.
FUNCTION float smoothLifeNext(float n, float m, vec4 b, float slopeN, float slopeM) {
  float alive = smoothStepAt(m, 0.5f, slopeM);
  precise float low = b.x + (b.z - b.x) * alive;
  precise float high = b.y + (b.w - b.y) * alive;
  float above = smoothStepAt(n, low, slopeN);
  float below = smoothStepAt(n, high, slopeN);
  precise float next = above * (1.0f - below);
  return next;
}

FUNCTION float leniaHeld(float value) {
  return exactFlush(min(max(value, 0.0f), 1.0f));
}
