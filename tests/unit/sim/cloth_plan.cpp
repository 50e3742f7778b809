#include "sim/cloth/plan.hpp"
#include "sim/core/shader_code.hpp"

#include <cmath>

#include <doctest/doctest.h>

using namespace simreel;

TEST_CASE("exact arithmetic is accurate") {
  double worst = 0;
  for (int i = 1; i < 20000; ++i) {
    const float x = std::ldexp(1.0F + static_cast<float>(i % 1000) / 1000.0F, i % 40 - 20);
    const auto error = [&](double got, double want) { return std::abs(got - want) / std::abs(want); };
    worst = std::max(worst, error(shader::exactInverseSqrt(x), 1.0 / std::sqrt(static_cast<double>(x))));
    worst = std::max(worst, error(shader::exactSqrt(x), std::sqrt(static_cast<double>(x))));
    worst = std::max(worst, error(shader::exactReciprocal(x), 1.0 / x));
    worst = std::max(worst, error(shader::exactReciprocal(-x), -1.0 / x));
  }
  CHECK(worst < 3e-7);
}

TEST_CASE("exact logarithm and power are accurate") {
  double worst = 0;
  const auto check = [&](int bits) {
    const float x = shader::intBitsToFloat(bits);
    const double right = std::log(static_cast<double>(x));
    if (x == 1.0F)
      CHECK(shader::exactLog(x) == 0.0F);
    else
      worst = std::max(worst, std::abs((static_cast<double>(shader::exactLog(x)) - right) / right));
  };
  const int least = shader::floatBitsToInt(1e-30F);
  for (int bits = least; bits < 0x7f800000; bits += 997) check(bits);
  for (int bits = shader::floatBitsToInt(0.7F); bits < shader::floatBitsToInt(1.42F); bits += 5)
    check(bits);
  CHECK(worst < 3e-7);
  worst = 0;
  for (const float y : {0.0F, 1e-3F, 1.0F / 3, 1.0F, 2.0F})
    for (int bits = least; bits < 0x7e800000; bits += 9973) {
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

TEST_CASE("exact sine, cosine and exponential are accurate") {
  double sine = 0;
  double exponential = 0;
  for (int i = -4000; i <= 4000; ++i) {
    const float x = static_cast<float>(i) * 0.01F;
    sine = std::max(sine, std::abs(shader::exactSin(x) - std::sin(static_cast<double>(x))));
    sine = std::max(sine, std::abs(shader::exactCos(x) - std::cos(static_cast<double>(x))) * 0.2);
    const double e = std::exp(static_cast<double>(x));
    exponential = std::max(exponential, std::abs(shader::exactExp(x) - e) / e);
  }
  CHECK(sine < 1e-6);
  CHECK(exponential < 1e-6);
  CHECK(shader::exactSqrt(0.0F) == 0.0F);
  CHECK(shader::exactExp(-100.0F) == 0.0F);
  CHECK(shader::exactFlush(1e-31F) == 0.0F);
}

TEST_CASE("the sheet starts flat, centred, last row pinned") {
  const sim::ClothPlan plan(sim::ClothParameters{}, 1, 1.0 / 60, {});
  const auto positions = plan.firstPositions();
  REQUIRE(positions.size() == 32 * 32);
  CHECK(positions[0].x == doctest::Approx(-1.55));
  CHECK(positions[0].y == 0.0F);
  CHECK(positions[0].z == doctest::Approx(-1.55));
  CHECK(positions[31].x == doctest::Approx(1.55));
  CHECK(positions[0].w == 1.0F);
  for (std::size_t i = 0; i < 32; ++i) CHECK(positions[31 * 32 + i].w == 0.0F);
}

TEST_CASE("pins by row, column, corner and point") {
  sim::ClothParameters p;
  p.size = {5, 4};
  sim::PinGroup group;
  group.rows = {0};
  group.every = 3;
  CHECK(p.pinnedBy(group) == std::vector<int>{0, 3, 4});
  group = {};
  group.columns = {-1};
  CHECK(p.pinnedBy(group) == std::vector<int>{4, 9, 14, 19});
  group = {};
  group.corners = {1, 2};
  group.points = {{2, 1}, {2, 1}};
  CHECK(p.pinnedBy(group) == std::vector<int>{4, 7, 15});
}

TEST_CASE("auto takes as many substeps as the springs need") {
  sim::ClothParameters p;
  p.substeps.reset();
  // w = sqrt(4 * 500 * 2.3 / 1) = 67.8 1/s, limit 2/w = 29.5 ms, times 0.7 = 20.6 ms: one substep of 16.7
  // ms.
  CHECK(p.substepsPerFrame(1.0 / 60) == 1);
  p.stiffness = 50000;
  CHECK(p.stableSeconds() == doctest::Approx(2.0 / std::sqrt(4 * 50000 * 2.3)).epsilon(1e-6));
  CHECK(p.substepsPerFrame(1.0 / 60) == 9);
}

TEST_CASE("damping does not depend on the number of substeps") {
  sim::ClothParameters p;
  for (const int n : {1, 4, 9}) {
    p.substeps = n;
    sim::ClothPlan plan(p, 1, 1.0 / 60, {});
    double kept = 1;
    for (const auto& step : plan.frame(0)) kept *= step.kept;
    CHECK(kept == doctest::Approx(std::exp(-4.85 / 60)).epsilon(1e-5));
  }
}
