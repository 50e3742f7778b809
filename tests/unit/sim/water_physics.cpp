#include "measured.hpp"
#include "reference/water_twin.hpp"
#include "sim/water/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

constexpr double earth = 9.81;

/// Returns a channel of 10 m around x = 0, with `cells` cells along x and two rows.
sim::WaterParameters channel(int cells, float left, float right) {
  sim::WaterParameters p;
  p.size = {cells, 2};
  p.cell = 10.0F / static_cast<float>(cells);
  p.bed = 0;
  p.level = right;
  p.pools = {{{-5, 0, -5}, {0, 0, 5}, left}};
  return p;
}

/// Returns the depth at x (m from the dam) at a time, for a dam break over a dry bed (Ritter 1892).
double ritter(double x, double time, double h) {
  const double c = std::sqrt(earth * h);
  if (x <= -c * time) return h;
  if (x >= 2 * c * time) return 0;
  return std::pow(2 * c - x / time, 2) / (9 * earth);
}

/// Returns the depth for a dam break over water of depth `low` (Stoker 1957). It has a rarefaction, a
/// constant middle part, and a shock.
double stoker(double x, double time, double high, double low) {
  const double c = std::sqrt(earth * high);
  double a = low;
  double b = high;
  for (int i = 0; i < 200; ++i) {  // Finds the depth of the middle part by bisection.
    const double m = 0.5 * (a + b);
    const double behindShock = (m - low) * std::sqrt(0.5 * earth * (m + low) / (m * low));
    (behindShock < 2 * (c - std::sqrt(earth * m)) ? a : b) = m;
  }
  const double u = 2 * (c - std::sqrt(earth * a));
  if (x <= -c * time) return high;
  if (x <= (u - std::sqrt(earth * a)) * time) return std::pow(2 * c - x / time, 2) / (9 * earth);
  return x <= a * u / (a - low) * time ? a : low;
}

/// Returns the mean error of a channel's depth (m) after 0.6 s.
double damError(const sim::WaterParameters& p, const std::function<double(double, double)>& exact) {
  constexpr double seconds = 0.6;
  WaterTwin twin(sim::WaterPlan(p, "dam", 1, seconds));
  twin.step(0);
  double sum = 0;
  for (int i = 0; i < p.size.x; ++i) {
    double mean = 0;
    constexpr int parts = 16;
    for (int k = 0; k < parts; ++k) mean += exact((i + (k + 0.5) / parts) * p.cell - 5.0, seconds) / parts;
    const glm::vec4& cell = twin.cells[static_cast<std::size_t>(i)];
    sum += std::abs(static_cast<double>(cell.x) - cell.w - mean);
  }
  return sum / p.size.x;
}

/// Returns the convergence order, which is the negative slope of log(error) over log(cells), fitted by
/// least squares.
double fittedOrder(const std::vector<int>& cells, float left, float right,
                   const std::function<double(double, double)>& exact) {
  double sx = 0;
  double sy = 0;
  double sxx = 0;
  double sxy = 0;
  for (const int n : cells) {
    const double error = damError(channel(n, left, right), exact);
    MESSAGE(n, " cells: mean error ", error, " m");
    const double x = std::log(n);
    const double y = std::log(error);
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  const auto n = static_cast<double>(cells.size());
  return -(n * sxy - sx * sy) / (n * sxx - sx * sx);
}

double dryDam(double x, double time) {
  return ritter(x, time, 1);
}
double wetDam(double x, double time) {
  return stoker(x, time, 1, 0.2);
}

double waterOf(const WaterTwin& twin, const char* name) {
  return named(sim::WaterParameters(), sim::measureWater(twin.plan(), twin.cells), name);
}

}  // namespace

TEST_CASE("water: dam breaks follow Ritter and Stoker and converge with more cells") {
  CHECK(stoker(1e9, 1, 1, 0.2) == 0.2);
  CHECK(fittedOrder({100, 200, 400}, 1, 0, dryDam) > 0.9);
  CHECK(fittedOrder({100, 200, 400}, 1, 0.2F, wetDam) > 0.9);
}

// This test is skipped by default. To run it, call test_unit -ns -tc='water: long*'
TEST_CASE("water: long: dam breaks with 100 to 3200 cells converge" * doctest::skip()) {
  const std::vector<int> cells = {100, 200, 400, 800, 1600, 3200};
  const double dry = fittedOrder(cells, 1, 0, dryDam);
  const double wet = fittedOrder(cells, 1, 0.2F, wetDam);
  MESSAGE("slopes: dry ", dry, ", wet ", wet);
  CHECK(dry >= 0.9);
  CHECK(wet >= 0.9);
}

TEST_CASE("water: a lake with islands stays at rest to the bit") {
  sim::WaterParameters p;
  p.size = {23, 17};
  p.cell = 0.37F;
  p.level = 0.31F;
  p.bed = -0.77F;
  p.hills = {{{-1.5F, 0, 0.3F}, {2, 0, 1.7F}, 1.6F}, {{2.6F, 0, -1}, {1.9F, 0, 2}, 0.9F}};
  p.drag = 0.0F;
  p.manning = 0.02F;
  for (const sim::WaterBorder border : {sim::WaterBorder::wall, sim::WaterBorder::open,
                                        sim::WaterBorder::periodic, sim::WaterBorder::sea}) {
    p.sides = {border, border, border, border};
    WaterTwin twin(sim::WaterPlan(p, "lake", 1, 1.0 / 30));
    const auto before = twin.cells;
    CHECK(waterOf(twin, "wetArea") < 0.99 * 23 * 17 * 0.37 * 0.37);  // The islands are dry.
    const shader::WaterStep step = twin.plan().stepAt(0);
    for (int i = 0; i < 10000; ++i) twin.advance(step);
    CHECK(twin.cells == before);
  }
}

TEST_CASE("water: water sloshing over islands conserves its volume") {
  sim::WaterParameters p;
  p.size = {41, 33};
  p.cell = 0.25F;
  p.level = 0.05F;
  p.bed = -0.5F;
  p.hills = {{{-2.5F, 0, 0.3F}, {2, 0, 1.7F}, 0.9F}, {{2.6F, 0, -1}, {1.9F, 0, 2}, 0.58F}};
  p.pools = {{{-6, 0, -5}, {-3.4F, 0, 5}, 0.6F}};
  WaterTwin twin(sim::WaterPlan(p, "lake", 1, 1.0 / 30));
  const double before = waterOf(twin, "volume");
  const shader::WaterStep step = twin.plan().stepAt(0);
  double minimum = 0;
  for (int i = 0; i < 10000; ++i) {
    twin.advance(step);
    if (i % 100 == 0)
      for (const glm::vec4& c : twin.cells) minimum = std::min(minimum, static_cast<double>(c.x) - c.w);
  }
  CHECK(minimum == 0);
  CHECK(std::abs(waterOf(twin, "volume") / before - 1) < 1e-6);
  CHECK(waterOf(twin, "fastest") > 1e-3);
}

TEST_CASE("water: rain, sources and drops add the stated volume") {
  sim::WaterParameters p;
  p.size = {30, 20};
  p.cell = 0.5F;
  p.rainfall = 36000.0F;  // rain of 1 cm per second
  WaterTwin rained(sim::WaterPlan(p, "pond", 1, 0.5));
  rained.step(0);
  CHECK(waterOf(rained, "volume") == doctest::Approx(150 * 1.005).epsilon(1e-6));

  p.rainfall = 0.0F;
  sim::StrokeParameters source;
  source.at = 0.1;
  source.until = 0.5;
  source.from = source.to = {10, 10, 0};
  source.radius = 2;
  source.value = 0.3;  // The source adds 0.3 m/s for 0.4 s.
  p.strokes = {source};
  p.substeps = 100;
  WaterTwin fed(sim::WaterPlan(p, "pond", 1, 1.0));
  fed.step(0);
  const double cells = 12;  // number of cells whose centres are within a distance of 2 from a grid corner
  CHECK(waterOf(fed, "volume") == doctest::Approx(150 + cells * 0.25 * 0.3 * 0.4).epsilon(2e-4));

  // The integral of (1 - r^2 / R^2)^2 over the disc is pi R^2 / 3.
  p.strokes.clear();
  p.substeps.reset();
  p.size = {200, 180};
  p.cell = 0.05F;
  p.drops = {{0.25, {0.3F, 0, -0.2F}, 1, 0.1F}};
  WaterTwin dropped(sim::WaterPlan(p, "pond", 1, 1.0));
  const double before = waterOf(dropped, "volume");
  dropped.step(0);
  CHECK(waterOf(dropped, "volume") - before == doctest::Approx(3.14159265 / 3 * 0.1).epsilon(1e-3));
}

TEST_CASE("water: a drain removes the stated volume, and never more than there is") {
  sim::WaterParameters p;
  p.size = {40, 44};
  p.cell = 0.25F;
  p.drains = {{{0.5F, 0, 0.2F}, 1, 0.4F, 0.5, 1.5}};
  WaterTwin twin(sim::WaterPlan(p, "basin", 1, 1.0 / 20));
  const double before = waterOf(twin, "volume");
  for (int frame = 0; frame < 40; ++frame) twin.step(frame / 20.0);
  CHECK(before - waterOf(twin, "volume") == doctest::Approx(3.14159265 / 3 * 0.4).epsilon(0.02));
  p.drains[0].speed = 50.0F;
  WaterTwin emptied(sim::WaterPlan(p, "basin", 1, 1.0 / 20));
  double lowest = 0;
  for (int frame = 0; frame < 40; ++frame) {
    emptied.step(frame / 20.0);
    for (const glm::vec4& c : emptied.cells) lowest = std::min(lowest, static_cast<double>(c.x) - c.w);
  }
  CHECK(lowest == 0);
  CHECK(waterOf(emptied, "volume") < 0.95 * before);
}

TEST_CASE("water: a stream decelerates by Manning's law") {
  // The friction is dv/dt = -g n^2 v^2 / h^(4/3) with roughness n. At h = 1, the inverse of the speed grows
  // by g n^2 per second.
  sim::WaterParameters p;
  p.size = {4, 4};
  p.cell = 10;
  p.bed = 0;
  p.level = 1;
  p.manning = 0.05F;
  p.sides.fill(sim::WaterBorder::periodic);
  WaterTwin twin(sim::WaterPlan(p, "stream", 1, 1.0 / 30));
  for (glm::vec4& cell : twin.cells) cell.y = 2;
  const shader::WaterStep step = twin.plan().stepAt(0);
  for (int i = 0; i < 300; ++i) twin.advance(step);
  const double seconds = 300 * twin.plan().stepSeconds();
  CHECK(1 / static_cast<double>(twin.cells[5].y) ==
        doctest::Approx(0.5 + earth * 0.0025 * seconds).epsilon(2e-3));
}

TEST_CASE("water: incoming waves have the given shape, travel at sqrt(g h) and leave") {
  sim::WaterParameters p;
  p.size = {240, 2};
  p.cell = 0.25F;
  p.bed = -2;
  p.sides = {sim::WaterBorder::sea, sim::WaterBorder::sea, sim::WaterBorder::wall, sim::WaterBorder::wall};
  // Three crests enter. Afterwards the sea is still.
  p.swell = {{0, scene::Animated<float>({{0, 0.04F}, {6, 0.04F}, {6.001, 0}}, scene::Ease::linear), 2, 0}};
  WaterTwin twin(sim::WaterPlan(p, "channel", 1, 1.0 / 20));
  const double c = std::sqrt(earth * 2);
  double maximum = 0;
  double latest = 0;
  for (int frame = 0; frame < 600; ++frame) {
    twin.step(frame / 20.0);
    const double seconds = (frame + 1) / 20.0;
    const double level = twin.cells[80].x;  // water level 20.1 m from the sea
    if (seconds > 5 && seconds < 9) {
      const double phase = 2 * 3.14159265358979 * (seconds - 20.125 / c) / 2;
      CHECK(std::abs(level - 0.02 * std::sin(phase)) < 3e-3);
      maximum = std::max(maximum, level);
    }
    if (seconds > 22) latest = std::max(latest, std::abs(level));
  }
  CHECK(maximum > 0.017);
  CHECK(latest < 0.02 * 0.02);
  CHECK(waterOf(twin, "volume") == doctest::Approx(60 * 0.5 * 2).epsilon(1e-3));
}
