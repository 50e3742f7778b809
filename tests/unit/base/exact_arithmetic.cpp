// Tests glsl/common/exact.glsl and the film's tone curve by comparison with the C library in double
// precision, which is exact to all digits of a float. Arguments are sampled densely. Where one power of two
// represents all others, every float in it is tested.
#include "draw/picture_code.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#define FUNCTION inline
#define precise
namespace simreel::shader {
#include "glsl/common/exact_acos.glsl"
}  // namespace simreel::shader
#undef precise
#undef FUNCTION

using namespace simreel;

namespace {

int bitsOf(float x) {
  return shader::floatBitsToInt(x);
}

/// Calls look(x) for every `step`-th float from `first` to `last`. Both bounds must be non-negative.
template <class Look>
void sweep(float first, float last, int step, Look look) {
  for (int bits = bitsOf(first); bits <= bitsOf(last); bits += step) look(shader::intBitsToFloat(bits));
}

double relative(float got, double wanted) {
  return std::abs((static_cast<double>(got) - wanted) / wanted);
}

}  // namespace

TEST_CASE(
    "exact arithmetic: reciprocals and inverse square roots of all floats are within their error bounds") {
  double reciprocal = 0;
  double inverse = 0;
  double root = 0;
  sweep(1, 4, 1, [&](float x) {
    const auto wide = static_cast<double>(x);
    reciprocal = std::max(reciprocal, relative(shader::exactReciprocal(x), 1 / wide));
    inverse = std::max(inverse, relative(shader::exactInverseSqrt(x), 1 / std::sqrt(wide)));
    root = std::max(root, relative(shader::exactSqrt(x), std::sqrt(wide)));
  });
  CHECK(reciprocal < 3e-7);
  CHECK(inverse < 3e-7);
  CHECK(root < 3e-7);
  // Other powers of two give the same digits, so a few samples are enough.
  int others = 0;
  for (int power = -98; power <= 98; power += 2)
    sweep(1, 4, 99991, [&](float x) {
      const float scaled = std::ldexp(x, power);
      others += shader::exactReciprocal(scaled) != std::ldexp(shader::exactReciprocal(x), -power) ? 1 : 0;
      others += shader::exactReciprocal(-scaled) != -shader::exactReciprocal(scaled) ? 1 : 0;
      others +=
          shader::exactInverseSqrt(scaled) != std::ldexp(shader::exactInverseSqrt(x), -power / 2) ? 1 : 0;
    });
  CHECK(others == 0);
  CHECK(shader::exactSqrt(0.0F) == 0.0F);
  CHECK(shader::exactFlush(1e-31F) == 0.0F);
}

TEST_CASE("exact arithmetic: sine, cosine and exponential are within their error bounds") {
  double sine = 0;
  double cosine = 0;
  const auto both = [&](float x) {
    const auto wide = static_cast<double>(x);
    sine = std::max(sine, std::abs(static_cast<double>(shader::exactSin(x)) - std::sin(wide)));
    // exactCos adds a quarter turn to the argument and rounds the sum, which causes this error.
    const double rounded = 2e-7 + 6e-8 * std::abs(wide);
    cosine =
        std::max(cosine, std::abs(static_cast<double>(shader::exactCos(x)) - std::cos(wide)) / rounded);
  };
  sweep(0, 1e4F, 499, [&](float x) {
    both(x);
    both(-x);
  });
  CHECK(sine < 4e-7);
  CHECK(cosine < 2);
  double exponential = 0;
  sweep(0, 69, 251, [&](float x) {
    for (const float signed_ : {x, -x})
      exponential = std::max(exponential,
                             relative(shader::exactExp(signed_), std::exp(static_cast<double>(signed_))));
  });
  CHECK(exponential < 3e-7);
  CHECK(shader::exactExp(-100.0F) == 0.0F);
  CHECK(shader::exactExp(100.0F) == shader::exactExp(69.0F));
}

TEST_CASE("exact arithmetic: logarithm and power are within their error bounds") {
  double worst = 0;
  const auto check = [&](int bits) {
    const float x = shader::intBitsToFloat(bits);
    const double right = std::log(static_cast<double>(x));
    if (x == 1.0F)
      CHECK(shader::exactLog(x) == 0.0F);
    else
      worst = std::max(worst, std::abs((static_cast<double>(shader::exactLog(x)) - right) / right));
  };
  const int minimum = shader::floatBitsToInt(1e-30F);
  for (int bits = minimum; bits < 0x7f800000; bits += 251) check(bits);
  for (int bits = shader::floatBitsToInt(0.7F); bits < shader::floatBitsToInt(1.42F); bits += 5)
    check(bits);
  CHECK(worst < 3e-7);
  worst = 0;
  for (const float y : {0.0F, 1e-3F, 1.0F / 3, 1.0F, 2.0F})
    for (int bits = minimum; bits < 0x7e800000; bits += 2513) {
      const float x = shader::intBitsToFloat(bits);
      const double power = static_cast<double>(y) * std::log(static_cast<double>(x));
      if (std::abs(power) > 68.9) continue;
      const double right = std::exp(power);
      const double error = std::abs(static_cast<double>(shader::exactPow(x, y)) - right) / right;
      worst = std::max(worst, error / (1 + std::abs(power)));
    }
  CHECK(worst < 4e-7);
  CHECK(shader::exactPow(0.0F, 0.5F) == 0.0F);
  CHECK(shader::exactPow(0.0F, 0.0F) == 1.0F);
}

TEST_CASE("exact arithmetic: acos is within its error bound") {
  double worst = 0;
  for (int i = -100000; i <= 100000; ++i) {
    const float x = static_cast<float>(i) * 1e-5F;
    worst = std::max(
        worst, std::abs(static_cast<double>(shader::exactAcos(x)) - std::acos(static_cast<double>(x))));
  }
  CHECK(worst < 1e-6);
  CHECK(shader::exactAcos(1.0F) == 0.0F);
  CHECK(shader::exactAcos(-1.0F) == 3.14159265F);
}

TEST_CASE("exact arithmetic: the sRGB encoding of light is within its error bound") {
  double worst = 0;
  double worstOfBright = 0;
  sweep(0, 1, 101, [&](float x) {
    const auto wide = static_cast<double>(x);
    const double wanted = wide < 0.0031308 ? 12.92 * wide : 1.055 * std::pow(wide, 1 / 2.4) - 0.055;
    const double error = std::abs(static_cast<double>(shader::encodedOne(x)) - wanted);
    worst = std::max(worst, error);
    if (wide > 0.021) worstOfBright = std::max(worstOfBright, error);
  });
  CHECK(worst < 1e-3);
  CHECK(worstOfBright < 3e-4);
}
