// Tests particles on known orbits, and tests conserved quantities. Uses the CPU twin, which equals the GPU
// bit for bit.
#include "reference/particles_twin.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

constexpr double pi = std::numbers::pi;

struct Start {
  glm::vec3 position;
  glm::vec3 velocity;
  float mass;
};

/// Returns a twin of the given bodies with one substep per frame.
ParticlesTwin bodies(const std::vector<Start>& starts, double gravity, double softening, double dt) {
  sim::ParticleParameters p;
  p.gravity = static_cast<float>(gravity);
  p.softening = static_cast<float>(softening);
  p.groups.emplace_back().count = static_cast<int>(starts.size());
  ParticlesTwin twin(sim::ParticlePlan(p, 1, dt));
  for (std::size_t i = 0; i < starts.size(); ++i) {
    twin.positions[i] = glm::vec4(starts[i].position, starts[i].mass);
    twin.velocities[i] = glm::vec4(starts[i].velocity, 0);
  }
  return twin;
}

ParticlesTwin sphere(int count, double dt, float softening = 0.1F) {
  sim::ParticleParameters p;
  p.gravity = 1;
  p.softening = softening;
  auto& group = p.groups.emplace_back();
  group.shape = sim::ParticleGroup::Shape::plummer;
  group.count = count;
  return ParticlesTwin(sim::ParticlePlan(p, 1, dt));
}

struct Energy {
  double kinetic = 0;
  double potential = 0;
  [[nodiscard]] double total() const { return kinetic + potential; }
};

Energy energy(const ParticlesTwin& twin) {
  Energy e;
  const auto& p = twin.plan().parameters();
  const double squared = static_cast<double>(p.softening) * p.softening;
  for (std::size_t i = 0; i < twin.positions.size(); ++i) {
    const glm::dvec3 v(twin.velocities[i]);
    e.kinetic += 0.5 * twin.positions[i].w * glm::dot(v, v);
    for (std::size_t j = 0; j < i; ++j) {
      const glm::dvec3 d = glm::dvec3(twin.positions[i]) - glm::dvec3(twin.positions[j]);
      e.potential -= static_cast<double>(p.gravity) * twin.positions[i].w * twin.positions[j].w /
                     std::sqrt(glm::dot(d, d) + squared);
    }
  }
  return e;
}

glm::dvec3 momentum(const ParticlesTwin& twin) {
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < twin.positions.size(); ++i)
    sum += glm::dvec3(twin.velocities[i]) * static_cast<double>(twin.positions[i].w);
  return sum;
}

glm::dvec3 angularMomentum(const ParticlesTwin& twin) {
  glm::dvec3 sum(0);
  for (std::size_t i = 0; i < twin.positions.size(); ++i)
    sum += glm::cross(glm::dvec3(twin.positions[i]), glm::dvec3(twin.velocities[i])) *
           static_cast<double>(twin.positions[i].w);
  return sum;
}

/// Returns two bodies with masses 3 and 1 that orbit their common centre, with G = 1 and semi-major axis 1,
/// starting at apoapsis.
std::vector<Start> ellipse(double eccentricity) {
  const double reach = 1 + eccentricity;
  const double speed = std::sqrt(4.0 * (2 / reach - 1));
  const auto at = [&](double fraction) {
    return Start{glm::vec3(fraction * reach, 0, 0), glm::vec3(0, 0, fraction * speed), 0};
  };
  Start heavy = at(-0.25);
  Start light = at(0.75);
  heavy.mass = 3;
  light.mass = 1;
  return {heavy, light};
}

constexpr double ellipsePeriod = pi;  // orbital period, 2 pi sqrt(a^3 / (G (m1 + m2)))

/// Returns the angle (rad) between the bodies and the apoapsis after some periods.
double phaseError(int stepsPerPeriod, int periods) {
  auto twin = bodies(ellipse(0.3), 1, 1e-5, ellipsePeriod / stepsPerPeriod);
  for (int i = 0; i < stepsPerPeriod * periods; ++i) twin.step(i * ellipsePeriod / stepsPerPeriod);
  const glm::dvec3 d = glm::dvec3(twin.positions[1]) - glm::dvec3(twin.positions[0]);
  return std::abs(std::atan2(d.z, d.x));
}

}  // namespace

TEST_CASE("two bodies keep period and eccentricity over 100 periods") {
  constexpr int steps = 2000;
  const double dt = ellipsePeriod / steps;
  auto twin = bodies(ellipse(0.3), 1, 1e-5, dt);
  std::vector<double> passages;  // upward crossings of the x axis on the side opposite to the start
  double min = 1e9;
  double max = 0;
  double before = 0;
  for (int i = 0; i < 100 * steps + steps / 2; ++i) {
    twin.step(i * dt);
    const glm::dvec3 d = glm::dvec3(twin.positions[1]) - glm::dvec3(twin.positions[0]);
    if (i >= 99 * steps) {
      min = std::min(min, glm::length(d));
      max = std::max(max, glm::length(d));
    }
    if (before < 0 && d.z >= 0 && d.x > 0) passages.push_back((i + 1 - d.z / (d.z - before)) * dt);
    before = d.z;
  }
  REQUIRE(passages.size() >= 100);
  const double period = passages.back() / static_cast<double>(passages.size());
  CHECK(period == doctest::Approx(ellipsePeriod).epsilon(2e-5));
  CHECK((max - min) / (max + min) == doctest::Approx(0.3).epsilon(1e-3).scale(0));
}

TEST_CASE("the phase error of leapfrog falls four times when the step is halved") {
  const double coarse = phaseError(100, 4);
  const double middle = phaseError(200, 4);
  const double fine = phaseError(400, 4);
  CHECK(coarse > 1e-3);
  CHECK(coarse / middle == doctest::Approx(4).epsilon(0.1));
  CHECK(middle / fine == doctest::Approx(4).epsilon(0.1));
}

TEST_CASE("three bodies return to their start on the figure-eight orbit") {
  // The orbit is the figure eight of A. Chenciner and R. Montgomery, Annals of Mathematics 152 (2000), with
  // C. Simo's numbers and G = m = 1.
  const glm::vec3 x(0.97000436, -0.24308753, 0);
  const glm::vec3 v(-0.93240737, -0.86473146, 0);
  constexpr double period = 6.32591398;
  constexpr int steps = 8000;
  auto twin =
      bodies({{x, v * -0.5F, 1}, {-x, v * -0.5F, 1}, {glm::vec3(0), v, 1}}, 1, 1e-5, period / steps);
  const auto first = twin.positions;
  for (int i = 0; i < 3 * steps; ++i) {
    twin.step(i * period / steps);
    if (i + 1 == steps / 3) {
      // After a third of the period, each body is at another body's initial position.
      for (const auto& p : twin.positions) {
        double nearest = 1e9;
        for (const auto& q : first) nearest = std::min<double>(nearest, glm::length(glm::vec3(p - q)));
        CHECK(nearest < 5e-3);
      }
      CHECK(glm::length(glm::vec3(twin.positions[0] - first[0])) > 0.5);
    }
  }
  for (std::size_t i = 0; i < 3; ++i) CHECK(glm::length(glm::vec3(twin.positions[i] - first[i])) < 2e-3);
}

TEST_CASE("a Plummer sphere is in equilibrium and keeps its energy") {
  // In model units, the crossing time is M^(5/2) / (2 |E|)^(3/2). M is the total mass, and E = -3 pi / 64 G
  // M^2 / a is the energy.
  const double crossing = 1 / std::pow(2 * 3 * pi / 64, 1.5);
  constexpr int steps = 100;
  auto twin = sphere(501, crossing / steps);
  const Energy first = energy(twin);
  CHECK(energy(sphere(8001, 1)).total() == doctest::Approx(-3 * pi / 64).epsilon(0.03).scale(0));
  double virial = 0;
  for (int i = 0; i < 10 * steps; ++i) {
    twin.step(i * crossing / steps, 0);
    if (i % 50 == 49) {
      const Energy e = energy(twin);
      virial += 2 * e.kinetic / -e.potential / 20;
      CHECK(std::abs(e.total() / first.total() - 1) < 1e-3);
    }
  }
  CHECK(virial == doctest::Approx(1).epsilon(0.06));
}

TEST_CASE("momentum and angular momentum are conserved") {
  auto twin = sphere(301, 0.02);
  for (auto& v : twin.velocities) v += glm::vec4(0.1F, -0.05F, 0.2F, 0);
  for (auto& p : twin.positions) p += glm::vec4(0.3F, 0, -0.2F, 0);
  const auto p = momentum(twin);
  const auto l = angularMomentum(twin);
  CHECK(glm::length(p) > 0.1);
  for (int i = 0; i < 200; ++i) twin.step(i * 0.02, 0);
  CHECK(glm::length(momentum(twin) - p) < 1e-5);
  CHECK(glm::length(angularMomentum(twin) - l) < 2e-5);
}

TEST_CASE("permuted bodies give the permuted result") {
  // The bits differ, because sums are computed in the order of the bodies. The difference must be only
  // rounding.
  auto twin = sphere(257, 0.02);
  auto other = sphere(257, 0.02);
  const auto place = [](std::size_t i) { return i * 100 % 257; };
  for (std::size_t i = 0; i < 257; ++i) {
    other.positions[place(i)] = twin.positions[i];
    other.velocities[place(i)] = twin.velocities[i];
  }
  for (int i = 0; i < 30; ++i) {
    twin.step(i * 0.02);
    other.step(i * 0.02);
  }
  float max = 0;
  for (std::size_t i = 0; i < 257; ++i)
    max = std::max(max, glm::length(glm::vec3(twin.positions[i] - other.positions[place(i)])));
  CHECK(max < 2e-5F);
}

TEST_CASE("with reversed velocities the particles return to their start") {
  auto twin = sphere(129, 0.01, 0.3F);
  const auto first = twin.positions;
  for (int i = 0; i < 100; ++i) twin.step(i * 0.01);
  float moved = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
    moved = std::max(moved, glm::length(glm::vec3(twin.positions[i] - first[i])));
  CHECK(moved > 0.5F);
  for (auto& v : twin.velocities) v = glm::vec4(-glm::vec3(v), v.w);
  for (int i = 0; i < 100; ++i) twin.step(i * 0.01);
  for (std::size_t i = 0; i < first.size(); ++i) {
    const float scale = std::max(1.0F, glm::length(glm::vec3(first[i])));
    CHECK(glm::length(glm::vec3(twin.positions[i] - first[i])) < 1e-5F * scale);
  }
}

TEST_CASE("damping is a rate independent of substeps, and weight falls g t^2 / 2") {
  for (const int substeps : {1, 7}) {
    sim::ParticleParameters p;
    p.method = sim::GravityMethod::none;
    p.groups.emplace_back().count = 3;
    p.groups[0].velocity = glm::vec3(2, 0, 0);
    p.damping = 0.8F;
    p.substeps = substeps;
    ParticlesTwin twin(sim::ParticlePlan(p, 1, 1.0 / 60));
    for (int i = 0; i < 60; ++i) twin.step(i / 60.0);
    CHECK(twin.velocities[2].x == doctest::Approx(2 * std::exp(-0.8)).epsilon(1e-5));
    p.damping = 0;
    p.acceleration = glm::vec3(0, -9.8F, 0);
    ParticlesTwin falling(sim::ParticlePlan(p, 1, 1.0 / 60));
    const float height = falling.positions[1].y;
    for (int i = 0; i < 60; ++i) falling.step(i / 60.0);
    CHECK(falling.positions[1].y - height == doctest::Approx(-4.9).epsilon(1e-5));
  }
}

TEST_CASE("a particle circles the attractor with Kepler's period") {
  sim::ParticleParameters p;
  p.method = sim::GravityMethod::none;
  p.attractor.emplace();
  p.attractorSoftening = 1e-5F;
  p.groups.emplace_back().count = 1;
  const double period =
      2 * pi * 2 * std::sqrt(2.0);  // period of a circular orbit with radius 2 and G M = 1
  ParticlesTwin twin(sim::ParticlePlan(p, 1, period / 4000));
  twin.positions[0] = glm::vec4(2, 0, 0, 1);
  twin.velocities[0] = glm::vec4(0, 0, std::sqrt(0.5F), 0);
  for (int i = 0; i < 4000; ++i) twin.step(i * period / 4000);
  CHECK(glm::length(glm::vec3(twin.positions[0]) - glm::vec3(2, 0, 0)) < 2e-4F);
}

TEST_CASE("turbulence is divergence-free with mean zero and unit strength") {
  double square = 0;
  glm::dvec3 mean(0);
  double divergence = 0;
  double slope = 0;
  int count = 0;
  for (int i = 0; i < 4000; ++i) {
    // The points are a low-discrepancy sequence in 40^3 cells (powers of the inverse of a generalized
    // golden ratio).
    const glm::dvec3 at =
        glm::fract(glm::dvec3(0.8191725, 0.6710436, 0.5497005) * static_cast<double>(i)) * 40.0;
    const glm::vec3 p(at);
    const glm::dvec3 v(curlNoiseAt(p, 3));
    mean += v;
    square += glm::dot(v, v);
    ++count;
    constexpr float h = 1.0F / 64;
    const glm::vec3 cell = glm::fract(p);
    if (std::min({cell.x, cell.y, cell.z}) < 2 * h || std::max({cell.x, cell.y, cell.z}) > 1 - 2 * h)
      continue;
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      glm::vec3 step(0);
      step[axis] = h;
      const double d = (curlNoiseAt(p + step, 3)[axis] - curlNoiseAt(p - step, 3)[axis]) / (2.0 * h);
      sum += d;
      slope += d * d;
    }
    divergence += sum * sum;
  }
  CHECK(std::sqrt(divergence / slope) < 0.01);
  CHECK(glm::length(mean) / count < 0.1);
  CHECK(std::sqrt(square / count) == doctest::Approx(1).epsilon(0.1));
}

TEST_CASE("any number of threads gives the same bits") {
  auto one = sphere(333, 0.02);
  auto all = sphere(333, 0.02);
  for (int i = 0; i < 5; ++i) {
    one.step(i * 0.02, 1);
    all.step(i * 0.02, 0);
  }
  CHECK(one.positions == all.positions);
  CHECK(one.velocities == all.velocities);
}
