#include "base/ieee.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>

#include <doctest/doctest.h>

namespace ieee = simreel::ieee;

namespace {

/// Returns the maximum relative error of `ours` with respect to the C library's long double function
/// `theirs`, over evenly spaced values.
template <class Ours, class Theirs>
double worstError(double first, double last, Ours ours, Theirs theirs) {
  long double worst = 0;
  constexpr int count = 200003;
  for (int i = 0; i <= count; ++i) {
    const double x = first + (last - first) * i / count;
    const long double right = theirs(static_cast<long double>(x));
    if (right == 0) continue;
    worst = std::max(worst, std::abs((static_cast<long double>(ours(x)) - right) / right));
  }
  return static_cast<double>(worst);
}

std::uint64_t bitsOf(double x) {
  return std::bit_cast<std::uint64_t>(x);
}

constexpr double unit = 2.220446049250313e-16;  // 2^-52, the spacing of doubles at 1
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("elementary functions of doubles: exponentials agree with the C library") {
  const auto naturalExp = [](long double x) { return std::exp(x); };
  const auto binaryExp = [](long double x) { return std::exp2(x); };
  CHECK(worstError(-708, 709, ieee::exp, naturalExp) < unit);
  CHECK(worstError(-1, 1, ieee::exp, naturalExp) < unit);
  CHECK(worstError(-1e-9, 1e-9, ieee::exp, naturalExp) < unit);
  CHECK(worstError(-1021, 1023.49, ieee::exp2, binaryExp) < unit);
  CHECK(worstError(-4, 4, ieee::exp2, binaryExp) < unit);
  for (int n = -1021; n <= 1023; ++n) REQUIRE(ieee::exp2(n) == std::ldexp(1.0, n));
  CHECK(ieee::exp(-708.5) == 0);
  CHECK(ieee::exp(709.5) == infinity);
  CHECK(ieee::exp2(-1021.5) == 0);
  CHECK(ieee::exp2(1023.5) == infinity);
}

TEST_CASE("elementary functions of doubles: logarithms and powers agree with the C library") {
  const auto natural = [](long double x) { return std::log(x); };
  const auto binary = [](long double x) { return std::log2(x); };
  for (const double last : {1e-300, 1e-6, 1.0, 1e6, 1e300}) {
    CHECK(worstError(last / 1e4, last, ieee::log, natural) < unit);
    CHECK(worstError(last / 1e4, last, ieee::log2, binary) < unit);
  }
  CHECK(worstError(0.999, 1.001, ieee::log, natural) < unit);
  CHECK(worstError(0.6, 1.6, ieee::log2, binary) < unit);
  for (int n = -1022; n <= 1023; ++n) REQUIRE(ieee::log2(std::ldexp(1.0, n)) == n);
  CHECK(ieee::log(0) == -infinity);
  CHECK(ieee::log2(0) == -infinity);
  for (const double y : {-40.5, -1.0, -0.4, 1 / 3.0, 1 / 2.4, 0.5, 2.4, 7.0, 90.0})
    for (const double last : {1.0, 2.0, 1000.0})
      CHECK(worstError(
                last / 1e3, last, [y](double x) { return ieee::pow(x, y); },
                [y](long double x) { return std::pow(x, static_cast<long double>(y)); }) < 2 * unit);
  CHECK(ieee::pow(0, 0.5) == 0);
  CHECK(ieee::pow(0, 0) == 1);
  CHECK(ieee::pow(0, -1) == infinity);
  CHECK(ieee::pow(1, 1e9) == 1);
  CHECK(ieee::pow(9, 0.5) == 3);
}

TEST_CASE("elementary functions of doubles: sine, cosine and tangent agree with the C library") {
  const auto sine = [](long double x) { return std::sin(x); };
  const auto cosine = [](long double x) { return std::cos(x); };
  const auto tangent = [](long double x) { return std::tan(x); };
  for (const double last : {1e-8, 0.5, 4.0, 1000.0, 1e6}) {
    CHECK(worstError(-last, last, ieee::sin, sine) < unit);
    CHECK(worstError(-last, last, ieee::cos, cosine) < unit);
    CHECK(worstError(-last, last, ieee::tan, tangent) < 2 * unit);
  }
  // Near zeros of sine and cosine, the result depends on the precision of the argument reduction.
  for (int n = 1; n < 600000; n += n < 1000 ? 1 : 997) {
    const double x = n * 1.5707963267948966;
    const auto exact = static_cast<long double>(x);
    REQUIRE(std::abs(static_cast<long double>(n % 2 == 0 ? ieee::sin(x) : ieee::cos(x)) -
                     (n % 2 == 0 ? std::sin(exact) : std::cos(exact))) < 1e-25L);
  }
  CHECK(ieee::sin(0) == 0);
  CHECK(ieee::cos(0) == 1);
  CHECK(ieee::tan(0) == 0);
}

TEST_CASE("elementary functions of doubles have the same bits with every compiler") {
  CHECK(bitsOf(ieee::exp(1)) == 0x4005bf0a8b145769ULL);
  CHECK(bitsOf(ieee::exp(-0.7)) == 0x3fdfc80db9dd5542ULL);
  CHECK(bitsOf(ieee::exp(3.3e-5)) == 0x3ff000229a842684ULL);
  CHECK(bitsOf(ieee::exp(345.6)) == 0x5f182ca33b1c0ee6ULL);
  CHECK(bitsOf(ieee::exp(-700.1)) == 0x00cf52f93df4dfcfULL);
  CHECK(bitsOf(ieee::exp2(0.5)) == 0x3ff6a09e667f3bccULL);
  CHECK(bitsOf(ieee::exp2(-1.3)) == 0x3fd9fdf8bcce533dULL);
  CHECK(bitsOf(ieee::exp2(0.1)) == 0x3ff125fbee250664ULL);
  CHECK(bitsOf(ieee::exp2(1000.7)) == 0x7e79fdf8bcce5424ULL);
  CHECK(bitsOf(ieee::log(2)) == 0x3fe62e42fefa39efULL);
  CHECK(bitsOf(ieee::log(0.3)) == 0xbff34378fcbda721ULL);
  CHECK(bitsOf(ieee::log(1.00001)) == 0x3ee4f8aea9af0a25ULL);
  CHECK(bitsOf(ieee::log(1e300)) == 0x4085963447f87fb5ULL);
  CHECK(bitsOf(ieee::log(7e-300)) == 0xc08586a30ea16688ULL);
  CHECK(bitsOf(ieee::log2(3)) == 0x3ff95c01a39fbd68ULL);
  CHECK(bitsOf(ieee::log2(0.9)) == 0xbfc374d65d9e608dULL);
  CHECK(bitsOf(ieee::log2(1e-5)) == 0xc0309c1165ec0627ULL);
  CHECK(bitsOf(ieee::pow(0.2, 2.4)) == 0x3f95843a60b3ce1dULL);
  CHECK(bitsOf(ieee::pow(0.7, 1 / 2.4)) == 0x3feb94b1f4a70e25ULL);
  CHECK(bitsOf(ieee::pow(123.4, -1 / 3.0)) == 0x3fc9b5cd93d66905ULL);
  CHECK(bitsOf(ieee::pow(1e-7, 17.5)) == 0x2680b939edd90a3dULL);
  CHECK(bitsOf(ieee::sin(1)) == 0x3feaed548f090ceeULL);
  CHECK(bitsOf(ieee::sin(3.1415926)) == 0x3e6cc553391a625fULL);
  CHECK(bitsOf(ieee::sin(-100.5)) == 0x3f9fb3f833470ff1ULL);
  CHECK(bitsOf(ieee::sin(999999.9)) == 0xbfdc45dd2caf2607ULL);
  CHECK(bitsOf(ieee::cos(1)) == 0x3fe14a280fb5068cULL);
  CHECK(bitsOf(ieee::cos(1.5707963267948966)) == 0x3c91a62633145c07ULL);
  CHECK(bitsOf(ieee::cos(-77.7)) == 0xbfe55cf9c92e02cbULL);
  CHECK(bitsOf(ieee::cos(654321.1)) == 0xbfed8f207b7c7108ULL);
  CHECK(bitsOf(ieee::tan(0.4)) == 0x3fdb0f0b49dcdcd8ULL);
  CHECK(bitsOf(ieee::tan(1.57)) == 0x40939f0ff737e7f3ULL);
  CHECK(bitsOf(ieee::tan(-12345.6)) == 0x3ff28d5b3daaede1ULL);
}

TEST_CASE("elementary functions of doubles: inverse trigonometric functions agree with the C library") {
  long double worst = 0;
  for (int i = -2003; i <= 2003; ++i)
    for (const double x : {-3.0, -1.0, -0.37, -1e-9, 0.0, 1e-12, 0.2, 1.0, 7.5}) {
      const double y = i / 977.0;
      if (x == 0 && y == 0) continue;
      const long double right = std::atan2(static_cast<long double>(y), static_cast<long double>(x));
      worst = std::max(worst, std::abs(static_cast<long double>(ieee::atan2(y, x)) - right));
    }
  CHECK(static_cast<double>(worst) < 3.2 * 8.9e-16);
  CHECK(ieee::atan2(0, 0) == 0);
  CHECK(ieee::atan2(0, -1) == 3.141592653589793);
}
