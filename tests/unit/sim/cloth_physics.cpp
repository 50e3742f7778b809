// Tests cloth by comparison with analytic results and conservation laws. Uses the CPU twin, which equals
// the GPU bit for bit.
#include "reference/cloth_twin.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

constexpr double frameSeconds = 1.0 / 60;

/// Returns a sheet without gravity, wind, damping or pins.
sim::ClothParameters freeSheet(int width, int height) {
  sim::ClothParameters p;
  p.size = {width, height};
  p.gravity = glm::vec3(0);
  p.wind = glm::vec3(0);
  p.damping = 0;
  p.pins.clear();
  return p;
}

ClothTwin makeTwin(const sim::ClothParameters& p, const std::vector<sim::ColliderShape>& colliders = {}) {
  return ClothTwin(sim::ClothPlan(p, 3, frameSeconds, colliders));
}

glm::dvec3 momentum(const ClothTwin& twin) {
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < twin.positions.size(); ++i)
    if (twin.positions[i].w > 0)
      sum += glm::dvec3(twin.velocities[i]) / static_cast<double>(twin.positions[i].w);
  return sum;
}

/// Returns the sum of kinetic, elastic and gravitational energy in J.
double energy(ClothTwin& twin) {
  const auto& p = twin.plan().parameters();
  const glm::dvec3 g(p.gravity.at(0));
  double sum = 0;
  const auto at = [&](int x, int y) { return static_cast<std::size_t>(y * p.size.x + x); };
  const auto spring = [&](int x, int y, int dx, int dy, double rest, double k) {
    if (x + dx < 0 || x + dx >= p.size.x || y + dy >= p.size.y) return;
    const double d =
        glm::length(glm::dvec3(twin.positions[at(x + dx, y + dy)]) - glm::dvec3(twin.positions[at(x, y)]));
    sum += 0.5 * k * (d - rest) * (d - rest);
  };
  for (int y = 0; y < p.size.y; ++y)
    for (int x = 0; x < p.size.x; ++x) {
      const auto i = at(x, y);
      if (twin.positions[i].w > 0) {
        const glm::dvec3 v(twin.velocities[i]);
        sum += 0.5 * p.mass * glm::dot(v, v) - p.mass * glm::dot(g, glm::dvec3(twin.positions[i]));
      }
      const double rest = p.spacing;
      spring(x, y, 1, 0, rest, p.stiffness);
      spring(x, y, 0, 1, rest, p.stiffness);
      spring(x, y, 1, 1, rest * std::sqrt(2.0), static_cast<double>(p.stiffness) * p.shear);
      spring(x, y, -1, 1, rest * std::sqrt(2.0), static_cast<double>(p.stiffness) * p.shear);
      spring(x, y, 2, 0, rest * 2, static_cast<double>(p.stiffness) * p.bend);
      spring(x, y, 0, 2, rest * 2, static_cast<double>(p.stiffness) * p.bend);
    }
  return sum;
}

}  // namespace

TEST_CASE("a mass on a spring swings with period 2 pi sqrt(m/k)") {
  auto p = freeSheet(2, 2);
  p.shear = 0;
  p.bend = 0;
  p.pins.emplace_back().columns = {0};
  p.substeps = 64;
  ClothTwin twin = makeTwin(p);
  for (const std::size_t i : {1U, 3U}) twin.positions[i].x += 0.01F;
  const double rest = 0.05;
  std::vector<double> crossings;
  double before = twin.positions[1].x - rest;
  int substep = 0;
  for (int frame = 0; frame < 120; ++frame)
    for (const auto& data : twin.plan().frame(frame * frameSeconds)) {
      twin.substep(data);
      ++substep;
      const double now = twin.positions[1].x - rest;
      if (before < 0 && now >= 0) crossings.push_back((substep - now / (now - before)) * frameSeconds / 64);
      before = now;
    }
  REQUIRE(crossings.size() > 4);
  const double period = (crossings.back() - crossings.front()) / static_cast<double>(crossings.size() - 1);
  CHECK(period == doctest::Approx(2 * 3.14159265358979 * std::sqrt(1.0 / 500)).epsilon(1e-3).scale(0));
}

TEST_CASE("constraints stretch by compliance times load for any number of substeps") {
  // Three masses of 1 kg hang below a pin. The first link carries 3 kg times g, the last 1 kg times g.
  for (const int substeps : {8, 16, 40}) {
    sim::ClothParameters p = freeSheet(2, 4);
    p.gravity = glm::vec3(0, -9.8F, 0);
    p.rotation = glm::vec3(90, 0, 0);
    p.solver = sim::ClothSolver::constraints;
    p.compliance = 1e-3F;
    p.shearCompliance = 1e6F;
    p.bendCompliance = 1e6F;
    p.damping = 5;
    p.substeps = substeps;
    p.pins.emplace_back().rows = {0};
    ClothTwin twin = makeTwin(p);
    for (int frame = 0; frame < 600; ++frame) twin.step(frame * frameSeconds);
    const double first = twin.positions[0].y - twin.positions[2].y;
    const double last = twin.positions[4].y - twin.positions[6].y;
    CHECK(first - 0.1 == doctest::Approx(3 * 9.8e-3).epsilon(0.03).scale(0));
    CHECK(last - 0.1 == doctest::Approx(9.8e-3).epsilon(0.03).scale(0));
  }
}

namespace {

/// Returns three columns with `rows` rows of cotton, 2 cm apart, without wind.
sim::ClothParameters longSheet(int rows) {
  sim::ClothParameters p = freeSheet(3, rows);
  p.spacing = 0.02F;
  p.mass = 0.2F * p.spacing * p.spacing;
  p.gravity = glm::vec3(0, -9.8F, 0);
  p.solver = sim::ClothSolver::constraints;
  p.shearCompliance = 1.0F / 300;
  p.bendCompliance = 1;
  p.substeps = 8;
  p.damping = 0.5F;
  return p;
}

/// Returns the length of the middle column relative to its rest length.
double columnStretch(const ClothTwin& twin, int rows) {
  double length = 0;
  for (int y = 0; y + 1 < rows; ++y) {
    const auto i = static_cast<std::size_t>(3 * y + 1);
    length +=
        static_cast<double>(glm::length(glm::vec3(twin.positions[i + 3]) - glm::vec3(twin.positions[i])));
  }
  return length / (0.02 * (rows - 1));
}

}  // namespace

TEST_CASE("rigid constraints hold for any number of hanging rows") {
  for (const int rows : {16, 64, 256, 1024}) {
    CAPTURE(rows);
    sim::ClothParameters p = longSheet(rows);
    p.substeps.reset();                // Without a value, "auto" applies.
    p.rotation = glm::vec3(90, 0, 0);  // The rotation makes the sheet hang.
    p.pins.emplace_back().rows = {0};
    ClothTwin twin = makeTwin(p);
    double worst = 0;
    for (int frame = 0; frame < 90; ++frame) {
      twin.step(frame * frameSeconds);
      worst = std::max(worst, columnStretch(twin, rows));
    }
    CHECK(worst < 1.003);
    CHECK(worst > 0.999);
  }
}

TEST_CASE("rigid constraints hold during a swing, and over a bar without pins") {
  constexpr int rows = 256;
  for (const bool swinging : {true, false}) {
    CAPTURE(swinging);
    sim::ClothParameters p = longSheet(rows);
    p.substeps = 16;  // At the lowest point, the tension is three times the weight.
    std::vector<sim::ColliderShape> bars;
    if (swinging) {
      p.pins.emplace_back().rows = {0};  // The sheet is horizontal at the start.
    } else {
      sim::ColliderShape bar;
      bar.kind = sim::ColliderShape::Kind::capsule;
      bar.rotation = glm::vec3(0, 0, 90);
      bar.length = 4;
      bar.radius = 0.3F;
      bar.position = glm::vec3(0, -0.35F, 0.1F);
      bars = {bar};
    }
    ClothTwin twin = makeTwin(p, bars);
    double worst = 0;
    for (int frame = 0; frame < 60; ++frame) {
      twin.step(frame * frameSeconds);
      worst = std::max(worst, columnStretch(twin, rows));
    }
    CHECK(worst < 1.01);
  }
}

TEST_CASE("rigid rows between pins that are too far apart, or taut, stay even and at rest") {
  for (const float scale : {1.0F, 1.2F}) {
    CAPTURE(scale);
    sim::ClothParameters p = freeSheet(65, 3);
    p.spacing = 0.02F;
    p.mass = 1e-4F;
    p.solver = sim::ClothSolver::constraints;
    p.substeps = 8;
    p.damping = 5;
    sim::PinGroup& ends = p.pins.emplace_back();
    ends.columns = {0, -1};
    ends.scale = glm::vec3(scale, 1, 1);
    ClothTwin twin = makeTwin(p);
    for (int frame = 0; frame < 150; ++frame) twin.step(frame * frameSeconds);
    double fastest = 0;
    double uneven = 0;
    for (std::size_t i = 65; i + 1 < 130; ++i) {
      fastest = std::max(fastest, static_cast<double>(glm::length(glm::vec3(twin.velocities[i]))));
      const double length = twin.positions[i + 1].x - twin.positions[i].x;
      uneven = std::max(uneven, std::abs(length / (0.02 * static_cast<double>(scale)) - 1));
    }
    CHECK(fastest < 0.02);
    CHECK(uneven < 0.1);
  }
}

TEST_CASE("a compliant line stretches by its weight: rho g H / 2k beyond its length") {
  constexpr int rows = 64;
  sim::ClothParameters p = longSheet(rows);
  p.rotation = glm::vec3(90, 0, 0);
  p.pins.emplace_back().rows = {0};
  p.compliance = 1.0F / 50;  // The stiffness is 50 N/m per thread.
  p.shearCompliance = 1e5F;  // The compliance is so large that diagonals carry no load.
  p.bendCompliance = 1e5F;
  p.damping = 6;
  ClothTwin twin = makeTwin(p);
  for (int frame = 0; frame < 400; ++frame) twin.step(frame * frameSeconds);
  // Link k from the top carries the rows below it.
  const double weight = static_cast<double>(p.mass) * 9.8;
  const double sum = weight * (rows - 1) * rows / 2 / 50;
  CHECK(columnStretch(twin, rows) - 1 == doctest::Approx(sum / (0.02 * (rows - 1))).epsilon(0.01).scale(0));
}

TEST_CASE("energy decays and never grows without wind") {
  sim::ClothParameters p;
  p.size = {17, 13};
  p.wind = glm::vec3(0);
  p.substeps = 16;
  p.damping = 1;
  ClothTwin twin = makeTwin(p);
  const double first = energy(twin);
  double before = first;
  double lowest = first;
  for (int frame = 0; frame < 600; ++frame) {
    twin.step(frame * frameSeconds);
    const double now = energy(twin);
    CHECK(now < before + 0.002 * (first - lowest) + 0.02);
    before = now;
    lowest = std::min(lowest, now);
  }
  CHECK(before < first - 100);
}

TEST_CASE("a free sheet conserves momentum, and gravity adds M g t") {
  auto p = freeSheet(19, 11);
  p.jitter = 0.03F;
  ClothTwin twin = makeTwin(p);
  double magnitude = 0;
  for (int frame = 0; frame < 120; ++frame) twin.step(frame * frameSeconds);
  for (const auto& v : twin.velocities) magnitude += glm::length(glm::vec3(v));
  CHECK(magnitude > 1);
  CHECK(glm::length(momentum(twin)) < 1e-4 * magnitude);

  p.gravity = glm::vec3(0, -9.8F, 0);
  ClothTwin falling = makeTwin(p);
  for (int frame = 0; frame < 60; ++frame) falling.step(frame * frameSeconds);
  CHECK(momentum(falling).y == doctest::Approx(-9.8 * 19 * 11).epsilon(1e-4));
}

TEST_CASE("a mirrored sheet moves as the mirror image") {
  sim::ClothParameters p;
  p.size = {15, 9};
  p.wind = glm::vec3(0, 0, 0.3F);
  ClothTwin twin = makeTwin(p);
  for (int frame = 0; frame < 120; ++frame) twin.step(frame * frameSeconds);
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 7; ++x) {
      const auto left = twin.positions[static_cast<std::size_t>(y * 15 + x)];
      const auto right = twin.positions[static_cast<std::size_t>(y * 15 + 14 - x)];
      CHECK(std::abs(left.x + right.x) < 2e-3);
      CHECK(std::abs(left.y - right.y) < 2e-3);
      CHECK(std::abs(left.z - right.z) < 2e-3);
    }
}

TEST_CASE("no particle is below the ground at the end") {
  sim::ClothParameters p;
  p.size = {13, 13};
  p.pins.clear();
  p.rotation = glm::vec3(35, 20, 10);
  p.margin = 0;
  sim::ColliderShape ground;
  ground.kind = sim::ColliderShape::Kind::plane;
  ground.position = glm::vec3(0, -1, 0);
  for (const auto solver : {sim::ClothSolver::springs, sim::ClothSolver::constraints}) {
    p.solver = solver;
    ClothTwin twin = makeTwin(p, {ground});
    bool touched = false;
    for (int frame = 0; frame < 240; ++frame) {
      twin.step(frame * frameSeconds);
      for (const auto& position : twin.positions) {
        REQUIRE(position.y >= -1.0F);
        touched = touched || position.y < -0.999F;
      }
    }
    CHECK(touched);
  }
}

TEST_CASE("friction: cloth sticks below the friction angle and slides by Coulomb's law above it") {
  for (const auto solver : {sim::ClothSolver::springs, sim::ClothSolver::constraints})
    for (const double degrees : {5.0, 10.0, 20.0, 40.0}) {
      CAPTURE(degrees);
      constexpr double coefficient = 0.2;  // friction coefficient, the tangent of 11.3 degrees
      sim::ClothParameters p = freeSheet(9, 7);
      p.solver = solver;
      p.gravity = glm::vec3(0, -9.8F, 0);
      p.margin = 0;
      p.damping = 0;
      p.rotation = glm::vec3(0, 0, static_cast<float>(degrees));
      sim::ColliderShape slope;
      slope.kind = sim::ColliderShape::Kind::plane;
      slope.rotation = glm::vec3(0, 0, static_cast<float>(degrees));
      slope.friction = coefficient;
      ClothTwin twin = makeTwin(p, {slope});
      const glm::vec3 start(twin.positions[31]);
      const double angle = degrees / 57.29577951308232;
      const double pull = std::sin(angle) - coefficient * std::cos(angle);
      const int frames = pull < 0 ? 600 : 60;
      for (int frame = 0; frame < frames; ++frame) twin.step(frame * frameSeconds);
      const double gone = glm::length(glm::dvec3(twin.positions[31]) - glm::dvec3(start));
      if (pull < 0)
        CHECK(gone < 1e-4);
      else
        CHECK(gone == doctest::Approx(0.5 * 9.8 * pull).epsilon(0.01).scale(0));
    }
}

TEST_CASE("air drag on a flat face is half rho Cd A v^2 without lift, and an inclined face has lift") {
  auto p = freeSheet(5, 5);
  p.air.emplace();
  p.air->velocity = glm::vec3(0, 3, 0);
  p.air->gusts = 0;
  p.substeps = 1;
  ClothTwin twin = makeTwin(p);
  twin.substep(twin.plan().frame(0).front());
  const glm::vec3 v(twin.velocities[12]);
  CHECK(v.y == doctest::Approx(0.5 * 1.2 * 1.0 * 0.01 * 9.0 * frameSeconds).epsilon(1e-4).scale(0));
  CHECK(std::abs(v.x) < 1e-6);
  // At an angle of attack of 45 degrees, lift is perpendicular to the flow. It is half of rho Cl A sin cos
  // v^2, and points upwards for air from below.
  p.air->velocity = glm::vec3(3, 3, 0);
  p.air->drag = 0;
  ClothTwin inclined = makeTwin(p);
  inclined.substep(inclined.plan().frame(0).front());
  const glm::vec3 w(inclined.velocities[12]);
  CHECK(std::abs(w.x + w.y) < 1e-6);
  CHECK(glm::length(w) ==
        doctest::Approx(0.5 * 1.2 * 0.6 * 0.01 * 18.0 * 0.5 * frameSeconds).epsilon(1e-3).scale(0));
}
