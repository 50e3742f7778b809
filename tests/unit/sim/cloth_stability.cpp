// Tests the stability of cloth. Compares the stated limit with the spectrum of the lattice, with one
// oscillator integrated in double precision, and with simulations close to the limit.
#include "base/error.hpp"
#include "measured.hpp"
#include "reference/cloth_twin.hpp"
#include "sim/cloth/quantities.hpp"
#include "unit/help.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;
using simreel::test::has;

namespace {

/// Returns a sheet without gravity, wind, damping or pins.
sim::ClothParameters springs(glm::ivec2 size, float stiffness, float shear, float bend, float mass) {
  sim::ClothParameters p;
  p.size = size;
  p.stiffness = stiffness;
  p.shear = shear;
  p.bend = bend;
  p.mass = mass;
  p.gravity = glm::vec3(0);
  p.wind = glm::vec3(0);
  p.damping = 0;
  p.pins.clear();
  return p;
}

/// Returns the square of the highest angular frequency of the sheet at rest, (1/s)^2. It is the largest
/// eigenvalue of the stiffness matrix (sum of k n n^T over the springs, with stiffness k and direction n),
/// found by power iteration.
double fastestSquared(const sim::ClothParameters& p) {
  const int w = p.size.x;
  const int h = p.size.y;
  std::vector<glm::dvec2> x(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = {std::sin(1.7 * static_cast<double>(i * i) + 0.3), std::cos(2.3 * static_cast<double>(i * i))};
  double largest = 0;
  for (int round = 0; round < 4000; ++round) {
    std::vector<glm::dvec2> y(x.size(), glm::dvec2(0));
    const auto spring = [&](int dx, int dy, double k) {
      const glm::dvec2 n = glm::normalize(glm::dvec2(dx, dy));
      for (int j = 0; j + dy < h; ++j)
        for (int i = std::max(0, -dx); i < w && i + dx < w; ++i) {
          const auto a = static_cast<std::size_t>(j * w + i);
          const auto b = static_cast<std::size_t>((j + dy) * w + i + dx);
          const glm::dvec2 force = n * (k * glm::dot(n, x[b] - x[a]));
          y[a] -= force;
          y[b] += force;
        }
    };
    const auto k = static_cast<double>(p.stiffness);
    spring(1, 0, k);
    spring(0, 1, k);
    spring(1, 1, k * p.shear);
    spring(-1, 1, k * p.shear);
    spring(2, 0, k * p.bend);
    spring(0, 2, k * p.bend);
    double square = 0;
    for (const glm::dvec2& v : y) square += glm::dot(v, v);
    largest = std::sqrt(square);
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = y[i] / largest;
  }
  return largest / p.mass;
}

/// Returns the maximum speed (m/s) after 2,000 substeps of `dt`, starting from a small random displacement.
double speedAfter(sim::ClothParameters p, double dt) {
  p.substeps = 1;
  p.jitter = 1e-4F;
  ClothTwin twin(sim::ClothPlan(p, 3, dt, {}));
  double fastest = 0;
  for (int i = 0; i < 2000; ++i) {
    twin.step(i * dt);
    fastest = 0;
    for (const glm::vec4& v : twin.velocities)
      fastest = std::max(fastest, static_cast<double>(glm::length(glm::vec3(v))));
    if (!(fastest < 1e3)) return 1e3;
  }
  return fastest;
}

/// True if semi-implicit Euler for x'' = -w^2 x - c x' stays bounded.
bool staysBounded(double w2, double c, double dt) {
  double x = 1;
  double v = 1;
  for (int i = 0; i < 20000; ++i) {
    v += (-w2 * x - c * v) * dt;
    x += v * dt;
    if (!(std::abs(x) < 1e6)) return false;
  }
  return true;
}

std::string refusal(const sim::ClothParameters& p, double frameSeconds) {
  try {
    (void)sim::ClothPlan(p, 1, frameSeconds, {});
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::usage);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("cloth is stable up to its declared limit and unstable soon beyond it") {
  const sim::ClothParameters sheets[] = {
      springs({9, 7}, 500, 1, 0.3F, 1), springs({8, 13}, 40000, 0, 0, 0.02F),
      springs({11, 6}, 3000, 0.2F, 2, 0.5F), springs({7, 7}, 800, 4, 0.1F, 3)};
  for (const sim::ClothParameters& p : sheets) {
    const double limit = 2 / std::sqrt(fastestSquared(p));
    const double declared = p.stableSeconds();
    CAPTURE(p.stiffness);
    CAPTURE(declared / limit);
    CHECK(declared <= limit * 1.0001);
    CHECK(declared > limit * 0.7);
    // The bound is ten times the speed that the initial jitter of 0.1 mm causes.
    CHECK(speedAfter(p, declared * 0.98) < 10 * 1e-4 * 2 / limit);
    CHECK(speedAfter(p, limit * 1.05) == 1e3);
  }
}

TEST_CASE("the substeps of \"auto\" are stable for a sheet stretched many times by its weight") {
  auto p = springs({9, 33}, 100, 1, 0.3F, 1);
  p.pins.emplace_back().rows = {0};
  p.gravity = glm::vec3(0, -9.8F, 0);
  p.rotation = glm::vec3(90, 0, 0);
  p.damping = 0.5F;
  p.substeps.reset();
  const double frame = 1 / 15.0;
  const int substeps = p.substepsPerFrame(frame);
  CHECK(substeps > 1);
  CHECK(speedAfter(p, frame / substeps) < 100);
}

TEST_CASE("springs and drag together are stable up to the declared limit only") {
  for (const double speed : {0.5, 20.0, 150.0})
    for (const float stiffness : {0.0F, 10.0F, 5000.0F}) {
      auto p = springs({8, 8}, stiffness, 1, 0.3F, 0.01F);
      p.air.emplace();
      p.air->velocity = glm::vec3(0, static_cast<float>(speed), 0);
      p.air->gusts = 0;
      const double w2 = 4.0 * static_cast<double>(stiffness) * (1.0 + p.shear + p.bend) / p.mass;
      // drag coefficient for the default parameters of the air
      const double c = 1.2 * (1.0 + 0.6) * 0.1 * 0.1 * speed / p.mass;
      CAPTURE(stiffness);
      CAPTURE(speed);
      CHECK(staysBounded(w2, c, p.stableSeconds() * 0.999));
      CHECK_FALSE(staysBounded(w2, c, p.stableSeconds() * 1.01));
    }
}

TEST_CASE("stability uses the max air speed of the whole run, including gusts") {
  auto p = springs({8, 8}, 10, 1, 0.3F, 0.001F);
  p.air.emplace();
  p.air->gusts = 0;
  p.substeps = 4;
  const auto limit = [&](const scene::Animated<glm::vec3>& velocity) {
    p.air->velocity = velocity;
    return p.stableSeconds();
  };
  using Moving = scene::Animated<glm::vec3>;
  const double storm = limit(glm::vec3(0, 60, 80));
  CHECK(limit(glm::vec3(3, 0, 0)) > 2 * storm);
  CHECK(limit(Moving({{0, glm::vec3(0)}, {2, glm::vec3(0, 60, 80)}, {4, glm::vec3(1)}},
                     scene::Ease::smooth)) == storm);
  CHECK(p.instability(1 / 60.0) != "");
  p.air->velocity = Moving({{0, glm::vec3(0)}, {2, glm::vec3(0.1F)}}, scene::Ease::linear);
  CHECK(p.instability(1 / 60.0) == "");
  // Each of a gust's three components is at most the given fraction, so the wind is at most 1 + 3 sqrt(3)
  // times as fast.
  const double gusty = limit(glm::vec3(0, 10.0F * (1.0F + 3.0F * std::sqrt(3.0F)), 0));
  p.air->gusts = 3;
  CHECK(limit(glm::vec3(0, 10, 0)) == doctest::Approx(gusty).epsilon(1e-6));
}

TEST_CASE("too few substeps are reported with advice") {
  auto p = springs({8, 8}, 50000, 1, 0.3F, 0.01F);
  p.substeps = 4;
  const std::string few = p.instability(1 / 60.0);
  CHECK(has(few, "4 substeps are fewer than the 57 that its springs need"));
  CHECK(has(few, "\"substeps\": \"auto\""));
  p.substeps = 1;
  CHECK(has(p.instability(1 / 60.0), "1 substep is fewer than the 57"));
  p.substeps = 4;
  p.stiffness = 1e9F;
  const std::string stiff = p.instability(1 / 60.0);
  CHECK(has(stiff, "\"solver\": \"constraints\""));
  CHECK_FALSE(has(stiff, "auto"));
  p.solver = sim::ClothSolver::constraints;
  CHECK(p.instability(1 / 60.0) == "");
  // The limit for 300 hanging rows at 2 cm is sqrt(0.02 / (300 * 9.8)) = 2.608 ms.
  p.size = {4, 300};
  p.spacing = 0.02F;
  p.wind = glm::vec3(0);
  p.gravity = glm::vec3(0, -9.8F, 0);
  // Energy-conserving cloth needs three times as many substeps.
  CHECK(has(p.instability(1 / 60.0), "4 substeps are fewer than the 20 that its hanging rows need"));
  p.damping = 1e-3F;
  CHECK(has(p.instability(1 / 60.0), "4 substeps are fewer than the 7 that its hanging rows need"));
}

TEST_CASE("\"auto\" is refused if it would need more than the max number of substeps") {
  auto p = springs({8, 8}, 1e7F, 1, 0.3F, 0.01F);
  p.substeps.reset();
  // w = sqrt(4 * 1e7 * 2.3 / 0.01) = 95917 1/s, so a stable substep is 0.7 * 2 / w = 14.6 us, and 1/60 s
  // needs 1142.
  const std::string line = refusal(p, 1 / 60.0);
  CHECK(has(line, "\"auto\" would take 1142 a frame to be stable, more than 1024"));
  CHECK(has(line, "\"solver\": \"constraints\""));
  CHECK_FALSE(has(line, "\n"));
  CHECK(refusal(p, 1 / 67.0).empty());
  CHECK(p.substepsPerFrame(1 / 67.0) == 1023);
  p.solver = sim::ClothSolver::constraints;
  CHECK(refusal(p, 1 / 60.0).empty());
  // Strong drag needs shorter substeps with either solver.
  p.air.emplace();
  p.air->velocity = glm::vec3(200, 0, 0);
  p.air->density = 1e4F;
  p.mass = 1e-4F;
  for (const auto solver : {sim::ClothSolver::springs, sim::ClothSolver::constraints}) {
    p.solver = solver;
    const std::string air = refusal(p, 1 / 60.0);
    CHECK(has(air, "slow the air"));
    CHECK_FALSE(has(air, "constraints"));
  }
}

TEST_CASE("a damped sheet hanging by two corners comes to rest with speed 0") {
  // The lines alone would need 8 substeps. With 8, the sheet never comes to rest, because half of it hangs
  // from each corner.
  sim::ClothParameters p;
  p.fabric.emplace();
  p.size = {24, 24};
  p.spacing = 0.01F;
  p.rotation = {90, 0, 0};
  p.wind = glm::vec3(0);
  p.substeps.reset();
  p.pins = {sim::PinGroup()};
  p.pins[0].rows = {0};
  CHECK(p.maxOnOnePin() == 24);
  p.pins[0].rows.clear();
  p.pins[0].corners = {0, 1};
  CHECK(p.maxOnOnePin() == 288);
  const double frame = 1.0 / 60;
  CHECK(p.substepsPerFrame(frame) == 17);
  p.substeps = 9;
  CHECK(p.instability(frame) != "");
  p.substeps.reset();
  ClothTwin twin(sim::ClothPlan(p, 1, frame, {}));
  std::vector<glm::vec4> before;
  for (int i = 0; i < 360; ++i) {
    before = twin.positions;
    twin.step(i * frame);
  }
  float maximum = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    maximum = std::max(maximum, glm::distance(glm::vec3(before[i]), glm::vec3(twin.positions[i])));
  CHECK(maximum < 5e-5F);
  const auto quantity = [&](const std::vector<glm::vec4>& velocities, const char* name) {
    return named(p, sim::measureCloth(p, twin.positions, velocities, 0), name);
  };
  // The stored velocities include half a substep of gravity, 5 mm/s.
  CHECK(quantity(twin.velocities, "speed") > 4e-3);
  const auto actual = sim::actualVelocities(twin.positions, twin.velocities, twin.trends);
  CHECK(quantity(actual, "speed") < 1e-3);
  CHECK(quantity(actual, "kineticEnergy") < 1e-9);
}
