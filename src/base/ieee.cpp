#include "base/ieee.hpp"

#include "base/error.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace simreel::ieee {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// ln 2 and log2 e, each as a sum of two doubles. Products of ln2High with whole numbers up to 2^20 are
// exact in double precision.
constexpr double ln2High = 0x1.62e42fee00000p-1;
constexpr double ln2Low = 0x1.a39ef35793c76p-33;
constexpr double log2eHigh = 0x1.71547652b82fep+0;
constexpr double log2eLow = 0x1.777d0ffda0d24p-56;

/// Unevaluated sum of two doubles, which has about 106 bits. |low| is at most half a unit in the last place
/// of `high`.
struct Pair {
  double high, low;
};

/// Returns a + b without rounding error (Knuth).
Pair sumOf(double a, double b) {
  const double high = a + b;
  const double part = high - a;
  return {high, (a - (high - part)) + (b - part)};
}

/// Splits a into its upper and lower 26 bits (Veltkamp).
Pair halvesOf(double a) {
  const double scaled = 134217729.0 * a;  // the factor is 2^27 + 1
  const double high = scaled - (scaled - a);
  return {high, a - high};
}

/// Returns a * b without rounding error (Dekker).
Pair productOf(double a, double b) {
  const double high = a * b;
  const Pair x = halvesOf(a);
  const Pair y = halvesOf(b);
  return {high, ((x.high * y.high - high) + x.high * y.low + x.low * y.high) + x.low * y.low};
}

/// Returns the polynomial c[0] + c[1] z + c[2] z^2 + ...
template <int Count>
double polynomial(const double (&c)[Count], double z) {
  double sum = c[Count - 1];
  for (int i = Count - 2; i >= 0; --i) sum = sum * z + c[i];
  return sum;
}

/// Returns 2^n for -1022 <= n <= 1023.
double powerOfTwo(double n) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + static_cast<std::int64_t>(n)) << 52U);
}

/// Returns e^(r + low) for |r| <= 0.35, where `low` is at most a few units in the last place of r. Uses the
/// Taylor series 1 + (r + (r^2 (1/2 + r/6 + ...) + low (1 + r))).
double expOfSmall(double r, double low) {
  constexpr double c[] = {1.0 / 2,          1.0 / 6,        1.0 / 24,        1.0 / 120,
                          1.0 / 720,        1.0 / 5040,     1.0 / 40320,     1.0 / 362880,
                          1.0 / 3628800,    1.0 / 39916800, 1.0 / 479001600, 1.0 / 6227020800,
                          1.0 / 87178291200};
  return 1.0 + (r + (r * r * polynomial(c, r) + low * (1.0 + r)));
}

/// Returns e^(x.high + x.low), computed as 2^n e^r with r = x - n ln 2.
double expOf(Pair x) {
  if (x.high > 709.0) return infinity;
  if (x.high < -708.0) return 0.0;
  const double n = std::floor(x.high * log2eHigh + 0.5);
  const Pair r = sumOf(x.high - n * ln2High, x.low - n * ln2Low);
  return expOfSmall(r.high, r.low) * powerOfTwo(n);
}

/// Returns the natural logarithm. Writes x = 2^e m with m between sqrt(1/2) and sqrt(2), and s = (m - 1) /
/// (m + 1). Then log m = 2 (s + s^3 / 3 + s^5 / 5 + ...). The first term is computed as a Pair.
Pair logOf(double x) {
  constexpr double c[] = {1.0 / 3,  1.0 / 5,  1.0 / 7,  1.0 / 9,  1.0 / 11, 1.0 / 13,
                          1.0 / 15, 1.0 / 17, 1.0 / 19, 1.0 / 21, 1.0 / 23};
  const auto bits = std::bit_cast<std::uint64_t>(x);
  double e = static_cast<double>(static_cast<std::int64_t>(bits >> 52U) - 1023);
  double m = std::bit_cast<double>((bits & 0xfffffffffffffULL) | 0x3ff0000000000000ULL);
  if (m > 1.4142135623730951) {
    m *= 0.5;
    ++e;
  }
  const double over = m - 1.0;
  const Pair under = sumOf(m, 1.0);
  const double s = over / under.high;
  const Pair back = productOf(s, under.high);
  const double sLow = ((over - back.high) - back.low - s * under.low) / under.high;
  const double z = s * s;
  const double rest = 2.0 * (sLow + s * (z * polynomial(c, z)));
  const Pair first = sumOf(e * ln2High, 2.0 * s);
  const Pair all = sumOf(first.high, first.low + (e * ln2Low + rest));
  return all;
}

/// Angle x reduced modulo pi/2, so that x = quarters * pi/2 + r.
struct Turned {
  Pair r;
  unsigned quarters;  ///< number of quarter turns, modulo 4
};

/// Reduces an angle |x| <= 1e6 (Cody and Waite). pi/2 is represented as a sum of three parts. Products with
/// the first two parts are exact.
Turned turned(double x) {
  SIMREEL_CHECK(std::abs(x) <= 1e6);
  const double n = std::floor(x * 0.63661977236758134 + 0.5);
  const Pair r = sumOf(x - n * 0x1.921fb544p+0, -(n * 0x1.0b4611a6p-34));
  return {sumOf(r.high, r.low - n * 0x1.3198a2e037073p-69),
          static_cast<unsigned>(static_cast<std::int64_t>(n)) & 3U};
}

/// Returns the sum of the sine's Taylor series for |r| <= pi/4. Uses r.low to first order. cosOf() does the
/// same for the cosine.
double sinOf(Pair r) {
  constexpr double c[] = {-1.0 / 6,        1.0 / 120,        -1.0 / 5040,          1.0 / 362880,
                          -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000, 1.0 / 355687428096000};
  const double z = r.high * r.high;
  return r.high + (r.high * (z * polynomial(c, z)) + r.low * (1.0 - 0.5 * z));
}

double cosOf(Pair r) {
  constexpr double c[] = {
      1.0 / 24,        -1.0 / 720,         1.0 / 40320,          -1.0 / 3628800,
      1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000, -1.0 / 6402373705728000};
  const Pair z = productOf(r.high, r.high);
  const Pair first = sumOf(1.0, -0.5 * z.high);
  return first.high +
         (first.low + (z.high * z.high * polynomial(c, z.high) - 0.5 * z.low - r.high * r.low));
}

double sinOf(const Turned& x) {
  const double value = (x.quarters & 1U) != 0 ? cosOf(x.r) : sinOf(x.r);
  return (x.quarters & 2U) != 0 ? -value : value;
}

}  // namespace

double exp(double x) {
  return expOf({x, 0.0});
}

double exp2(double x) {
  if (x >= 1023.5) return infinity;
  if (x < -1021.0) return 0.0;
  const double n = std::floor(x + 0.5);
  // Ln 2 as a double; the next line adds its remainder.
  const Pair r = productOf(x - n, 0x1.62e42fefa39efp-1);
  return expOfSmall(r.high, r.low + (x - n) * 0x1.abc9e3b39803fp-56) * powerOfTwo(n);
}

double log(double x) {
  if (x <= 0) return -infinity;
  const Pair l = logOf(x);
  return l.high + l.low;
}

double log2(double x) {
  if (x <= 0) return -infinity;
  const Pair l = logOf(x);
  const Pair product = productOf(l.high, log2eHigh);
  return product.high + (product.low + (l.high * log2eLow + l.low * log2eHigh));
}

double pow(double x, double y) {
  if (y == 0) return 1.0;
  if (x <= 0) return y > 0 ? 0.0 : infinity;
  const Pair l = logOf(x);
  const Pair product = productOf(y, l.high);
  return expOf(sumOf(product.high, product.low + y * l.low));
}

double sin(double x) {
  return sinOf(turned(x));
}

double cos(double x) {
  Turned of = turned(x);
  ++of.quarters;
  return sinOf(of);
}

// Takes the quotient or its inverse, so that t <= 1. Halves the angle twice with tan(a / 2) = t / (1 +
// sqrt(1 + t^2)), which makes t at most tan(pi / 16). Then sums the Taylor series up to t^27.
double atan2(double y, double x) {
  constexpr double pi = 0x1.921fb54442d18p+1;
  const double high = std::fmax(std::fabs(x), std::fabs(y)), low = std::fmin(std::fabs(x), std::fabs(y));
  if (high == 0) return 0;
  double t = low / high;
  for (int i = 0; i < 2; ++i) t = t / (1 + std::sqrt(1 + t * t));
  double sum = 0;
  for (int i = 27; i >= 1; i -= 2) sum = 1.0 / i - t * t * sum;
  double angle = 4 * t * sum;
  if (std::fabs(y) > std::fabs(x)) angle = pi / 2 - angle;
  if (x < 0) angle = pi - angle;
  return y < 0 ? -angle : angle;
}

double tan(double x) {
  const Turned of = turned(x);
  const double s = sinOf(of.r);
  const double c = cosOf(of.r);
  return (of.quarters & 1U) != 0 ? -c / s : s / c;
}

}  // namespace simreel::ieee
