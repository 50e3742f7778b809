// Tests fluids by comparison with closed forms and published tables.
#include "reference/fluid_flows.hpp"
#include "reference/fluid_twin.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

using Side = sim::FluidSide::Kind;

sim::FluidParameters calmFluid(int width, int height) {
  sim::FluidParameters p;
  p.size = {width, height};
  p.strokes.clear();
  p.substeps = 1;
  return p;
}

double fluidEnergy(const FluidTwin& twin) {
  double sum = 0;
  for (int y = 0; y < twin.plan().size().y; ++y)
    for (int x = 0; x < twin.plan().size().x; ++x) {
      const glm::dvec4 cell(twin.flow[twin.index(x, y)]);
      sum += cell.x * cell.x + cell.y * cell.y;
    }
  return sum;
}

/// Result for Taylor-Green vortices of size 1 at speed 1 and Re 100 on n x n cells, after a third of the
/// energy is lost. It has the relative error of the energy's decay, and the maximum error of u relative to
/// the speed.
struct Vortices {
  double decay, error;
};
Vortices taylorGreen(int n) {
  const double k = 2 * std::numbers::pi / n;
  const double nu = 0.01 * n * n;
  const double seconds = 0.256;
  const int steps = 300 * n * n / 1024;  // number of steps; dt is proportional to h^2
  auto p = calmFluid(n, n);
  p.left.kind = p.right.kind = p.top.kind = p.bottom.kind = Side::periodic;
  p.viscosity = static_cast<float>(nu);
  p.speed = static_cast<float>(2 * n);
  FluidTwin twin(sim::FluidPlan(p, "vortices", 1, seconds / steps));
  const auto u = [&](double x, double y) { return n * std::sin(k * x) * std::cos(k * y); };
  for (int y = -1; y <= n; ++y)
    for (int x = -1; x <= n; ++x) {
      glm::vec4& cell = twin.flow[twin.index(x, y)];
      cell.x = static_cast<float>(u(x, y + 0.5));
      cell.y = static_cast<float>(-u(y, x + 0.5));
    }
  const double before = fluidEnergy(twin);
  for (int i = 0; i < steps; ++i) twin.step(i * seconds / steps);
  const double wanted = 4 * nu * k * k * seconds;
  const double got = std::log(before / fluidEnergy(twin));
  double error = 0;
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      const double exact = u(x, y + 0.5) * std::exp(-wanted / 2);
      error = std::max(error, std::abs(static_cast<double>(twin.flow[twin.index(x, y)].x) - exact));
    }
  return {std::abs(got / wanted - 1), error / n};
}

/// Returns flows::ghiaError() of an n x n cavity after its lid has moved `turns` times the cavity's width.
double cavityError(int n, double reynolds, double turns) {
  const double seconds = 0.25;
  FluidTwin twin(sim::FluidPlan(flows::cavity(n, reynolds), "cavity", 1, seconds));
  for (int i = 0; i < turns / seconds; ++i) twin.step(i * seconds);
  return flows::ghiaError(flows::ghia(reynolds), n, twin.flow);
}

}  // namespace

TEST_CASE("fluid: Taylor-Green vortices decay at the analytic rate with second-order error") {
  const Vortices coarse = taylorGreen(32);
  const Vortices fine = taylorGreen(64);
  MESSAGE("decay off by ", coarse.decay, " and ", fine.decay, ", errors ", coarse.error, " and ",
          fine.error);
  CHECK(coarse.decay < 0.01);
  CHECK(fine.decay < 0.01);
  CHECK(std::log2(coarse.error / fine.error) >= 1.8);
}

TEST_CASE("fluid: a lid-driven cavity at Re 100 equals Ghia's tables") {
  const double error = cavityError(32, 100, 14);
  MESSAGE("error ", error);
  CHECK(error < 0.01);
}

TEST_CASE("fluid: Taylor-Green vortices converge over 32 to 128 cells" * doctest::skip()) {
  const Vortices coarse = taylorGreen(32), middle = taylorGreen(64), fine = taylorGreen(128);
  MESSAGE("errors ", coarse.error, ", ", middle.error, ", ", fine.error);
  CHECK(std::log2(middle.error / fine.error) >= 1.8);
  CHECK(fine.decay < 0.01);
}

TEST_CASE("fluid: flow that crosses many cells per step does not grow") {
  sim::FluidParameters p;
  p.size = {47, 35};
  p.substeps = 1;
  sim::FluidStroke jet;
  jet.from = jet.to = {20, 15, 0};
  jet.until = 0.02;
  jet.radius = 4;
  jet.setsVelocity = true;
  p.strokes = {jet};
  for (const float cells : {2.5F, 4.0F, 7.0F}) {
    CAPTURE(cells);
    p.strokes[0].velocity = glm::vec3(60 * cells, 24 * cells, 0);
    FluidTwin twin(sim::FluidPlan(p, "f", 1, 1.0 / 60));
    for (int i = 0; i < 120; ++i) twin.step(i / 60.0);
    float fastest = 0;
    for (const glm::vec4& c : twin.flow) fastest = std::max({fastest, std::abs(c.x), std::abs(c.y)});
    MESSAGE("fastest ", fastest);
    CHECK(fastest > 20);
    CHECK(fastest < 60 * cells);
  }
}

TEST_CASE("fluid: the sum of dye stays constant, and no cell leaves the initial range") {
  auto p = calmFluid(37, 23);
  p.speed = 100;
  sim::FluidStroke push;
  push.from = push.to = {12, 10, 0};
  push.radius = 5;
  push.setsVelocity = push.setsDye = true;
  push.velocity = glm::vec3(70, 45, 0);
  p.strokes = {push};
  p.obstacles.resize(1);
  p.obstacles[0].center = glm::vec3(25, 12, 0);
  p.obstacles[0].radius = 4;
  FluidTwin twin(sim::FluidPlan(p, "bath", 1, 0.002));
  for (int y = 4; y < 18; ++y)
    for (int x = 3; x < 17; ++x)
      twin.dye[twin.index(x, y)] = {1, (x + y) % 2, 0.0625F * static_cast<float>(x), 0};
  twin.setStep(twin.plan().stepAt(0, 0));
  const auto sums = [&] {
    glm::dvec4 sum(0);
    for (int y = 0; y < p.size.y; ++y)
      for (int x = 0; x < p.size.x; ++x) sum += glm::dvec4(twin.dye[twin.index(x, y)]);
    return sum;
  };
  const glm::dvec4 before = sums();
  for (int i = 0; i < 10000; ++i) twin.moveDye();
  const glm::dvec4 after = sums();
  for (int c = 0; c < 3; ++c) CHECK(after[c] == before[c]);
  float minimum = 0, maximum = 0, moved = 0;
  for (const glm::vec4& cell : twin.dye) {
    minimum = std::min({minimum, cell.x, cell.y, cell.z});
    maximum = std::max({maximum, cell.x, cell.y});
  }
  for (int y = 0; y < p.size.y; ++y) moved += twin.dye[twin.index(33, y)].x;
  CHECK(minimum >= 0);
  CHECK(maximum <= 1.0F);
  CHECK(moved > 0.5F);
}
