#include "measured.hpp"
#include "reference/gray_scott_twin.hpp"
#include "sim/gray_scott/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

GrayScottTwin twinOf(glm::ivec2 size, sim::GrayScottPreset preset, int seeds) {
  sim::GrayScottParameters p;
  p.size = size;
  p.preset = preset;
  p.seedCount = seeds;
  return GrayScottTwin(sim::GrayScottPlan(p, "dish", 3, 1.0 / 30));
}

double sum(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

std::vector<double> grown(sim::GrayScottPreset preset) {
  auto twin = twinOf({97, 91}, preset, 12);
  twin.advance(twin.plan().ratesAt(0), 5000);
  return sim::measureGrayScott(twin.cells(), {97, 91});
}

double of(const std::vector<double>& measured, const char* name) {
  return named(sim::GrayScottParameters(), measured, name);
}

}  // namespace

TEST_CASE("grayScott: the state u = 1, v = 0 is unchanged to the bit") {
  auto twin = twinOf({13, 9}, sim::GrayScottPreset::stripes, 0);
  twin.advance(twin.plan().ratesAt(0), 500);
  CHECK(std::all_of(twin.u.begin(), twin.u.end(), [](float u) { return u == 1.0F; }));
  CHECK(std::all_of(twin.v.begin(), twin.v.end(), [](float v) { return v == 0.0F; }));
}

TEST_CASE("grayScott: uniform fields end at the stable uniform solution of the equations") {
  // In equilibrium, u v = F + k and F (1 - u) = (F + k) v, with feed rate F and kill rate k. So v = (1 +
  // sqrt(1 - 4 (F + k)^2 / F)) F / (2 (F + k)).
  auto twin = twinOf({9, 7}, sim::GrayScottPreset::chaos, 0);
  auto rates = twin.plan().ratesAt(0);
  const double F = 0.06;
  const double k = 0.05;
  rates.feed = static_cast<float>(F);
  rates.kill = static_cast<float>(k);
  const double v = (1 + std::sqrt(1 - 4 * (F + k) * (F + k) / F)) * F / (2 * (F + k));
  const double u = (F + k) / v;
  std::fill(twin.u.begin(), twin.u.end(), static_cast<float>(u + 0.01));
  std::fill(twin.v.begin(), twin.v.end(), static_cast<float>(v - 0.01));
  twin.advance(rates, 2000);
  for (const float x : twin.u) CHECK(x == doctest::Approx(u).epsilon(1e-5));
  for (const float x : twin.v) CHECK(x == doctest::Approx(v).epsilon(1e-5));
}

TEST_CASE("grayScott: mass changes per step as the equations say") {
  // Diffusion must conserve the sums of u and v over the torus.
  auto twin = twinOf({61, 47}, sim::GrayScottPreset::stripes, 4);
  const auto rates = twin.plan().ratesAt(0);
  const double F = rates.feed;
  const double k = rates.kill;
  twin.advance(rates, 300);
  for (int i = 0; i < 5; ++i) {
    double reacted = 0;
    for (std::size_t c = 0; c < twin.u.size(); ++c)
      reacted += static_cast<double>(twin.u[c]) * twin.v[c] * twin.v[c];
    const double u = sum(twin.u);
    const double v = sum(twin.v);
    const double wantU = u - reacted + F * (static_cast<double>(twin.u.size()) - u);
    const double wantV = v + reacted - (F + k) * v;
    twin.advance(rates, 1);
    CHECK(std::abs(sum(twin.u) - wantU) < 2e-5);
    CHECK(std::abs(sum(twin.v) - wantV) < 2e-5);
    CHECK(std::abs(sum(twin.v) - v) > 1e-3);
  }
}

TEST_CASE("grayScott: the Laplacian converges at second order") {
  // For cos(q x + p y), the stencil must return -0.3 (q^2 + p^2) cos(...), because half of its second
  // moment is 0.3.
  double before = 0;
  for (const int side : {16, 32, 64}) {
    const double q = 2 * std::numbers::pi / side;
    const auto f = [&](int x, int y) { return static_cast<float>(std::cos(q * x + 2 * q * y)); };
    double worst = 0;
    for (int x = 0; x < side; ++x) {
      const float edges = (f(x - 1, 0) + f(x + 1, 0)) + (f(x, -1) + f(x, 1));
      const float corners = (f(x - 1, -1) + f(x + 1, -1)) + (f(x - 1, 1) + f(x + 1, 1));
      const double lap = shader::laplacian20(f(x, 0), edges, corners) / 20;
      worst = std::max(worst, std::abs(lap / (0.3 * 5 * q * q) + f(x, 0)));
    }
    if (before > 0) CHECK(std::log2(before / worst) == doctest::Approx(2).epsilon(0.05));
    before = worst;
  }
}

TEST_CASE("grayScott: diffusion alone is stable up to the bound and unstable beyond") {
  const auto spread = [](double diffusion) {
    auto twin = twinOf({12, 10}, sim::GrayScottPreset::stripes, 0);
    auto rates = twin.plan().ratesAt(0);
    rates = {static_cast<float>(diffusion / 20), 0, 0, 0, 0, 0, 0};
    // In the fastest mode, rows and columns both alternate: cos(pi x) + cos(pi y).
    for (int i = 0; i < 120; ++i) {
      const int x = i % 12;
      const int y = i / 12;
      twin.u[static_cast<std::size_t>(i)] =
          0.5F + 0.001F * static_cast<float>((x % 2 == 0 ? 1 : -1) + (y % 2 == 0 ? 1 : -1)) +
          0.001F * static_cast<float>((x + y) % 2);
    }
    twin.advance(rates, 60);
    const auto [min, max] = std::minmax_element(twin.u.begin(), twin.u.end());
    return *max - *min;
  };
  CHECK(spread(0.99 * sim::maxGrayScottDiffusion) < 0.003F);
  CHECK(spread(1.1 * sim::maxGrayScottDiffusion) > 0.02F);
}

TEST_CASE("grayScott: wavelength and patch size of known patterns are found") {
  const glm::ivec2 size(120, 90);
  std::vector<float> waves;
  std::vector<char> dots;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      waves.push_back(static_cast<float>(std::sin(2 * std::numbers::pi * (x + y) / 30.0)));
      dots.push_back(static_cast<char>((x + 1) % 10 < 3 && (y + 2) % 15 < 4));
    }
  CHECK(sim::dominantWavelength(waves, size) == doctest::Approx(30 / std::numbers::sqrt2).epsilon(0.05));
  CHECK(sim::dominantWavelength(std::vector<float>(waves.size(), 0.5F), size) == 0);
  const sim::Patches patches = sim::patchesOf(dots, size);
  CHECK(patches.count == 12 * 6);  // Patches that cross the torus's seam count once.
  CHECK(patches.largest == 12);
}

TEST_CASE("grayScott: statistics distinguish spots from stripes") {
  const auto spots = grown(sim::GrayScottPreset::leopard);
  const auto stripes = grown(sim::GrayScottPreset::stripes);
  CHECK(of(spots, "spots") > 40);
  CHECK(of(spots, "largestSpot") < 0.02);
  CHECK(of(stripes, "spots") < 25);
  CHECK(of(stripes, "largestSpot") > 0.05);
  CHECK(of(spots, "wavelength") > 6);
  CHECK(of(spots, "wavelength") < 20);
}

TEST_CASE("grayScott: with the rates of \"spots\" every pattern dies out") {
  const auto left = grown(sim::GrayScottPreset::spots);
  CHECK(of(left, "mostV") < 1e-3);
  CHECK(of(left, "spots") == 0);
}
