#pragma once
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace simreel::golden {

// SIMD arithmetic on four neighbouring pixels. All processors execute the same operations in the same
// order, so the results are identical.

using Four = float __attribute__((vector_size(16)));
using FourInts = std::int32_t __attribute__((vector_size(16)));

inline Four load(const float* from) {
  Four four;
  std::memcpy(&four, from, sizeof four);
  return four;
}
inline void store(float* to, Four four) {
  std::memcpy(to, &four, sizeof four);
}

inline Four smaller(Four a, Four b) {
  return a < b ? a : b;
}
inline Four larger(Four a, Four b) {
  return a > b ? a : b;
}
inline Four magnitude(Four x) {
  return std::bit_cast<Four>(std::bit_cast<FourInts>(x) & 0x7fffffff);
}
inline Four squareRoot(Four x) {
  return Four{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
}

// Each function below needs positive normal numbers and has a relative error below 1e-6.

/// Returns the cube root. The float's bits give an estimate within 4%. Two Halley steps follow, each of
/// which triples the number of correct digits.
inline Four cubeRoot(Four x) {
  const Four third = __builtin_convertvector(std::bit_cast<FourInts>(x), Four) * (1 / 3.0f);
  Four root = std::bit_cast<Four>(__builtin_convertvector(third, FourInts) + 0x2a5137a0);
  for (int step = 0; step < 2; ++step) {
    const Four cube = root * root * root;
    root = root * (cube + x + x) / (cube + cube + x);
  }
  return root;
}

/// Returns the base-2 logarithm. Uses x = 2^n m with m between sqrt(1/2) and sqrt(2), and ln m = 2
/// artanh((m - 1) / (m + 1)).
inline Four log2Of(Four x) {
  const auto bits = std::bit_cast<FourInts>(x);
  const FourInts exponent = (bits - 0x3f3504f3) >> 23;
  const auto m = std::bit_cast<Four>(bits - (exponent << 23));
  const Four t = (m - 1) / (m + 1), t2 = t * t;
  const Four series = 1 + t2 * (1 / 3.0f + t2 * (1 / 5.0f + t2 * (1 / 7.0f + t2 * (1 / 9.0f))));
  return __builtin_convertvector(exponent, Four) + 2.88539008f * t * series;  // the constant is 2 / ln 2
}

/// Returns 2^y for y from -126 to 127. The integer part of y sets the exponent. A power series computes the
/// factor for the fractional part (at most 1/2 in magnitude).
inline Four exp2Of(Four y) {
  constexpr float toWhole = 12582912;  // 1.5 * 2^23: floats of this size have no fraction bits
  const Four shifted = y + toWhole;
  const FourInts whole = std::bit_cast<FourInts>(shifted) - std::bit_cast<std::int32_t>(toWhole);
  const Four f = (y - (shifted - toWhole)) * 0.693147181f;  // the constant is ln 2
  const Four series =
      1 + f * (1 + f * (1 / 2.0f + f * (1 / 6.0f + f * (1 / 24.0f + f * (1 / 120.0f + f * (1 / 720.0f))))));
  return series * std::bit_cast<Four>((whole + 127) << 23);
}

/// Returns x^y, or exactly 0 if x = 0. |y log2 x| must be below 126.
inline Four powerOf(Four x, Four y) {
  const Four power = exp2Of(y * log2Of(x));
  return x > 0 ? power : Four{};
}

}  // namespace simreel::golden
