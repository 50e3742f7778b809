// Tests the damping of stretch by comparison with closed forms. A vibration of angular frequency w must
// decay at the rate T w^2 / 2, where T is the damping time. Motion without stretching must not be damped.
#include "reference/cloth_twin.hpp"
#include "reference/garment_twin.hpp"
#include "unit/help.hpp"
#include "unit/sim/garment_help.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

constexpr double stripLength = 0.5;  // length of the strip, m
constexpr double stripStiffness = 40;
constexpr double stripDensity = 0.1;
constexpr double stripDamping = 0.008;  // damping time T of the strip, s

/// Returns a fabric strip along x that is held at its left end.
sim::ClothParameters dampedStrip(bool mesh, int cells) {
  sim::ClothParameters p = test::freeCloth();
  p.mesh.emplace();
  p.fabric.emplace();
  p.size = {cells + 1, 3};
  p.spacing = static_cast<float>(stripLength / cells);
  p.mesh->size = glm::vec3(stripLength, 0, 2 * stripLength / cells);
  p.mesh->resolution = {cells + 1, 3};
  p.fabric->density = stripDensity;
  p.fabric->weft = p.fabric->warp = stripStiffness;
  p.fabric->shear = 1;
  p.fabric->bending = 0;
  p.fabric->stretchDamping = stripDamping;
  p.substeps = 1;
  if (!mesh) p.mesh.reset();
  if (mesh)
    test::pinBox(p, glm::vec3(-9), glm::vec3(-0.499F * stripLength, 9, 9));
  else
    p.pins.emplace_back().columns = {0};
  return p;
}

/// Returns the decay rate (1/s) of the strip's first longitudinal mode, from its energy over two periods,
/// relative to T w^2 / 2. An implicit step adds as much damping as a damping time T = dt.
template <class Twin>
double decayOf(Twin twin, double dt, int cells) {
  // This is the frequency of a row of masses with springs between them that is held at one end.
  const double frequency = 2 * cells / stripLength * std::sqrt(stripStiffness / stripDensity) *
                           std::sin(0.25 * std::numbers::pi / cells);
  const std::vector<glm::vec4> rest = twin.positions;
  const auto shape = [&](std::size_t i) {
    return std::sin(0.5 * std::numbers::pi * (static_cast<double>(rest[i].x) / stripLength + 0.5));
  };
  for (std::size_t i = 0; i < rest.size(); ++i)
    twin.positions[i].x += static_cast<float>(0.04 * stripLength * shape(i));
  const auto energy = [&] {
    double place = 0;
    double speed = 0;
    for (std::size_t i = 0; i < rest.size(); ++i) {
      if (rest[i].w == 0) continue;
      const double part = shape(i) / static_cast<double>(rest[i].w);
      place += part * static_cast<double>(twin.positions[i].x - rest[i].x);
      speed += part * static_cast<double>(twin.velocities[i].x);
    }
    return speed * speed + frequency * frequency * place * place;
  };
  const double expected = 0.5 * (stripDamping + dt) * frequency * frequency;
  const double period = 2 * std::numbers::pi / std::sqrt(frequency * frequency - expected * expected);
  const int before = static_cast<int>(std::lround(0.5 * period / dt));
  const int steps = static_cast<int>(std::lround(2 * period / dt));
  int step = 0;
  for (; step < before; ++step) twin.step(step * dt);
  const double first = energy();
  for (; step < before + steps; ++step) twin.step(step * dt);
  return 0.5 * std::log(first / energy()) / (steps * dt) / expected;
}

/// Checks a free sheet, which moves and spins about a tilted axis, after half a second.
template <class Twin>
void checkSpin(Twin twin, const std::vector<double>& masses) {
  const glm::dvec3 spin(1.5, 2, -3);
  const glm::dvec3 way(0.3, -0.2, 0.5);
  for (std::size_t i = 0; i < masses.size(); ++i)
    twin.velocities[i] = glm::vec4(glm::vec3(glm::cross(spin, glm::dvec3(twin.positions[i])) + way), 0);
  struct Motion {
    glm::dvec3 linear{0}, angular{0};
    double energy = 0;
  };
  const auto motion = [&] {
    Motion m;
    for (std::size_t i = 0; i < masses.size(); ++i) {
      const glm::dvec3 v(twin.velocities[i]);
      m.linear += masses[i] * v;
      m.angular += masses[i] * glm::cross(glm::dvec3(twin.positions[i]), v);
      m.energy += 0.5 * masses[i] * glm::dot(v, v);
    }
    return m;
  };
  const Motion before = motion();
  for (int step = 0; step < 500; ++step) twin.step(step * 1e-3);
  const Motion after = motion();
  // The tolerance covers rounding errors.
  CHECK(glm::distance(after.linear, before.linear) < 3e-3 * glm::length(before.linear));
  CHECK(glm::distance(after.angular, before.angular) < 0.003 * glm::length(before.angular));
  CHECK(after.energy == doctest::Approx(before.energy).epsilon(0.004).scale(0));
}

std::vector<double> massesOf(const std::vector<glm::vec4>& positions) {
  std::vector<double> masses;
  for (const glm::vec4& p : positions) masses.push_back(1 / static_cast<double>(p.w));
  return masses;
}

}  // namespace

TEST_CASE("fabric: vibrations of a stretched strip decay at stretchDamping w^2 / 2, for grids and meshes") {
  const double gridStep = 2e-4;
  const ClothTwin grid(sim::ClothPlan(dampedStrip(false, 16), 1, gridStep, {}));
  CHECK(decayOf(grid, gridStep, 16) == doctest::Approx(1).epsilon(0.03));
  const double meshStep =
      2e-4;  // A step solves the faces only once, so the damping is complete only for short steps.
  const GarmentTwin mesh(sim::GarmentPlan("strip", dampedStrip(true, 4), 1, meshStep, {}));
  CHECK(decayOf(mesh, meshStep, 4) == doctest::Approx(1).epsilon(0.03));
}

TEST_CASE("fabric: stretch damping does not affect rotation and translation") {
  for (const double damping : {0.0, 0.05}) {
    CAPTURE(damping);
    sim::ClothParameters p = dampedStrip(false, 8);
    p.pins.clear();
    p.size = {9, 7};
    p.fabric->stretchDamping = damping;
    p.fabric->weft = p.fabric->warp = 2000;
    p.fabric->shear = 100;
    const ClothTwin grid(sim::ClothPlan(p, 1, 1e-3, {}));
    checkSpin(grid, massesOf(grid.positions));
    p.mesh = dampedStrip(true, 8).mesh;
    const GarmentTwin mesh(sim::GarmentPlan("sheet", p, 1, 1e-3, {}));
    checkSpin(mesh, massesOf(mesh.positions));
  }
}
