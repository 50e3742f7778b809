// Fluids against closed forms and published tables.
#include "reference/fluid_twin.hpp"

#include <algorithm>
#include <array>
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

/// Taylor-Green vortices of size 1 at speed 1, Re 100, on n x n cells until a third of the energy is gone:
/// how far off the energy's decay is, as a share of it, and the greatest error of u over the speed.
struct Vortices {
  double decay, error;
};
Vortices taylorGreen(int n) {
  const double k = 2 * std::numbers::pi / n;
  const double nu = 0.01 * n * n;
  const double seconds = 0.256;
  const int steps = 300 * n * n / 1024;  // dt ~ h^2
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

/// Ghia, Ghia and Shin (1982), tables I and II: u along the vertical through the middle, v along the
/// horizontal.
constexpr double ghiaY[] = {0.9766, 0.9688, 0.9609, 0.9531, 0.8516, 0.7344, 0.6172, 0.5,
                            0.4531, 0.2813, 0.1719, 0.1016, 0.0703, 0.0625, 0.0547};
constexpr double ghiaX[] = {0.9688, 0.9609, 0.9531, 0.9453, 0.9063, 0.8594, 0.8047, 0.5,
                            0.2344, 0.2266, 0.1563, 0.0938, 0.0781, 0.0703, 0.0625};
struct Ghia {
  double reynolds;
  std::array<double, 15> u, v;
};
constexpr Ghia ghia100 = {100,
                          {0.84123, 0.78871, 0.73722, 0.68717, 0.23151, 0.00332, -0.13641, -0.20581,
                           -0.21090, -0.15662, -0.10150, -0.06434, -0.04775, -0.04192, -0.03717},
                          {-0.05906, -0.07391, -0.08864, -0.10313, -0.16914, -0.22445, -0.24533, 0.05454,
                           0.17527, 0.17507, 0.16077, 0.12317, 0.10890, 0.10091, 0.09233}};
constexpr Ghia ghia400 = {400,
                          {0.75837, 0.68439, 0.61756, 0.55892, 0.29093, 0.16256, 0.02135, -0.11477,
                           -0.17119, -0.32726, -0.24299, -0.14612, -0.10338, -0.09266, -0.08186},
                          {-0.12146, -0.15663, -0.19254, -0.22847, -0.23827, -0.44993, -0.38598, 0.05186,
                           0.30174, 0.30203, 0.28124, 0.22965, 0.20920, 0.19713, 0.18360}};
constexpr Ghia ghia1000 = {1000,
                           {0.65928, 0.57492, 0.51117, 0.46604, 0.33304, 0.18719, 0.05702, -0.06080,
                            -0.10648, -0.27805, -0.38289, -0.29730, -0.22220, -0.20196, -0.18109},
                           {-0.21388, -0.27669, -0.33714, -0.39188, -0.51550, -0.42665, -0.31966, 0.02526,
                            0.32235, 0.33075, 0.37095, 0.32627, 0.30353, 0.29012, 0.27485}};

/// The greatest difference from the tables, over the lid's speed, of an n x n cavity after `turns` of its
/// lid. A misprint of theirs, v(0.9063) at Re 400, is left out.
double cavityError(int n, const Ghia& table, double turns) {
  auto p = calmFluid(n, n);
  p.top.velocity = glm::vec3(n, 0, 0);
  p.speed = static_cast<float>(n);
  p.viscosity = static_cast<float>(n * n / table.reynolds);
  p.substeps.reset();
  p.courant = 0.8F;
  const double seconds = 0.25;
  FluidTwin twin(sim::FluidPlan(p, "cavity", 1, seconds));
  for (int i = 0; i < turns / seconds; ++i) twin.step(i * seconds);
  // Linear between nodes; nodes half a cell beyond the walls hold what makes the wall's speed.
  const auto between = [&](double place, const auto& node) {
    const int i = static_cast<int>(std::floor(place));
    return node(i) + (node(i + 1) - node(i)) * (place - i);
  };
  double worst = 0;
  for (std::size_t i = 0; i < 15; ++i) {
    const double u = between((1 - ghiaY[i]) * n - 0.5,
                             [&](int y) -> double { return twin.flow[twin.index(n / 2, y)].x; });
    const double v =
        between(ghiaX[i] * n - 0.5, [&](int x) -> double { return -twin.flow[twin.index(x, n / 2)].y; });
    worst = std::max(worst, std::abs(u / n - table.u[i]));
    if (table.reynolds != 400 || ghiaX[i] != 0.9063) worst = std::max(worst, std::abs(v / n - table.v[i]));
  }
  return worst;
}

}  // namespace

TEST_CASE("fluid: Taylor-Green vortices decay as they should, with an error of second order") {
  const Vortices coarse = taylorGreen(32);
  const Vortices fine = taylorGreen(64);
  MESSAGE("decay off by ", coarse.decay, " and ", fine.decay, ", errors ", coarse.error, " and ",
          fine.error);
  CHECK(coarse.decay < 0.01);
  CHECK(fine.decay < 0.01);
  CHECK(std::log2(coarse.error / fine.error) >= 1.8);
}

TEST_CASE("fluid: a lid-driven cavity at Re 100 is Ghia's") {
  const double error = cavityError(32, ghia100, 14);
  MESSAGE("error ", error);
  CHECK(error < 0.02);
}

// build/tests/test_unit --no-skip -tc='fluid: 128*'
TEST_CASE("fluid: 128x128 cavities at Re 100, 400 and 1000 are Ghia's" * doctest::skip()) {
  for (const Ghia* table : {&ghia100, &ghia400, &ghia1000}) {
    const double re = table->reynolds;
    const double error = cavityError(128, *table, re < 200 ? 15 : re < 500 ? 30 : 45);
    MESSAGE("Re ", re, ": error ", error);
    // Re 1000 has 0.0234: steps are of first order in time.
    CHECK(error < (re < 500 ? 0.02 : 0.025));
  }
}

TEST_CASE("fluid: Taylor-Green vortices over 32 to 128 cells" * doctest::skip()) {
  const Vortices coarse = taylorGreen(32), middle = taylorGreen(64), fine = taylorGreen(128);
  MESSAGE("errors ", coarse.error, ", ", middle.error, ", ", fine.error);
  CHECK(std::log2(middle.error / fine.error) >= 1.8);
  CHECK(fine.decay < 0.01);
}

TEST_CASE("fluid: the sum of dye stays, and no cell has less than none or more than there was") {
  auto p = calmFluid(37, 23);
  p.speed = 100;
  sim::FluidStroke push;
  push.from = push.to = {12, 10, 0};
  push.radius = 5;
  push.setsVelocity = push.setsDye = true;
  push.velocity = glm::vec3(70, 45, 0);
  p.strokes = {push};
  p.obstacles.resize(1);
  p.obstacles[0].center = {25, 12, 0};
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
  float least = 0, most = 0, moved = 0;
  for (const glm::vec4& cell : twin.dye) {
    least = std::min({least, cell.x, cell.y, cell.z});
    most = std::max({most, cell.x, cell.y});
  }
  for (int y = 0; y < p.size.y; ++y) moved += twin.dye[twin.index(33, y)].x;
  CHECK(least >= 0);
  CHECK(most <= 1.0F);
  CHECK(moved > 0.5F);
}
