// Tests the energy of undamped swinging cloth over a minute. tools/bench/studies.cpp has more cases.
#include "reference/cloth_twin.hpp"
#include "reference/garment_twin.hpp"
#include "reference/swing.hpp"
#include "sim/cloth/quantities.hpp"
#include "sim/garment/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

TEST_CASE("energy: undamped springs conserve energy for a minute") {
  for (const double degrees : {10.0, 45.0}) {
    CAPTURE(degrees);
    auto given = swing::springs(degrees, 0.1);
    given.parameters.substeps = 12;
    const auto course = swing::courseOfTwin(given, 60);
    CHECK(std::abs(course.drift()) < 0.01);
    CHECK(course.rise < 1e-3);
  }
}

TEST_CASE("energy: constraints of damped cloth conserve energy for a minute if nothing flutters") {
  auto given = swing::fabric(10, 0.1);
  given.parameters.damping = 1e-6F;
  given.parameters.size.x = 2;
  given.parameters.substeps = 16;
  REQUIRE(!given.parameters.keepsEnergy());
  const auto course = swing::courseOfTwin(given, 60);
  CHECK(std::abs(course.drift()) < 0.01);
  CHECK(course.rise < 4e-3);  // The energy is evaluated as for short substeps.
}

TEST_CASE("energy: undamped fabrics and meshes conserve energy for a minute") {
  for (const bool mesh : {false, true})
    for (const double degrees : {10.0, 60.0}) {
      CAPTURE(mesh);
      CAPTURE(degrees);
      const auto course =
          swing::courseOfTwin(mesh ? swing::strip(degrees, 0.1) : swing::fabric(degrees, 0.1), 60);
      CHECK(std::abs(course.drift()) < 0.01);
      CHECK(course.rise < 2e-3);
    }
}

TEST_CASE("energy: a wide swing of a fine fabric conserves energy, including the energy lost to flutter") {
  // The cloth crumples within ten seconds. A second-order method would lose a tenth of the energy in that
  // time.
  const auto course = swing::courseOfTwin(swing::fabric(60, 0.05), 10);
  CHECK(std::abs(course.drift()) < 5e-3);
  CHECK(course.rise < 1e-3);
}

namespace {

/// Returns the maximum difference between the force that a substep exerts on a particle and the negative
/// gradient of the elastic energy, relative to the maximum force. The gradient is computed by finite
/// differences.
template <class Twin>
double missedGradient(Twin twin, const std::function<double(const std::vector<glm::vec4>&)>& elastic) {
  const std::vector<glm::vec4> start = twin.positions;
  const auto steps = twin.plan().frame(0);
  twin.substep(steps[0]);
  double maximum = 0;
  double missed = 0;
  for (std::size_t i = 0; i < start.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      if (start[i].w == 0) continue;
      constexpr float step = 1.0F / 8192;
      auto there = start;
      auto back = start;
      there[i][axis] += step;
      back[i][axis] -= step;
      const double way = static_cast<double>(there[i][axis]) - static_cast<double>(back[i][axis]);
      const double force = -(elastic(there) - elastic(back)) / way;
      const double found =
          static_cast<double>(twin.velocities[i][axis]) / static_cast<double>(start[i].w) / steps[0].dt;
      maximum = std::max(maximum, std::abs(force));
      missed = std::max(missed, std::abs(force - found));
    }
  CHECK(maximum > 0.001);
  return missed / maximum;
}

/// Returns the parameters of a crumpled sheet without gravity.
sim::ClothParameters crumpled() {
  sim::ClothParameters p;
  p.gravity = glm::vec3(0);
  p.wind = glm::vec3(0);
  p.damping = 0;
  p.substeps = 16;
  p.pins.clear();
  return p;
}

}  // namespace

TEST_CASE("energy: energy-conserving constraint forces are the gradient of the measured energy") {
  // The size is odd, there are pins, and lines consist of two segments.
  for (const bool fabric : {false, true}) {
    CAPTURE(fabric);
    sim::ClothParameters p = crumpled();
    p.size = {21, 5};
    p.spacing = 0.05F;
    p.solver = sim::ClothSolver::constraints;
    if (fabric) p.fabric.emplace();
    p.mass = 1e-3F;
    p.compliance = 2e-4F;
    p.shearCompliance = 1e-3F;
    p.bendCompliance = 1e-2F;
    p.jitter = 0.012F;
    // The pins create each kind of line: lines with one pin, lines with a pin at each end (unstretched or
    // stretched), and lines with two pins in between.
    p.pins.emplace_back().points = {{0, 0}, {20, 0}, {9, 2}, {13, 2}, {0, 4}, {20, 4}};
    REQUIRE(p.keepsEnergy());
    ClothTwin twin(sim::ClothPlan(p, 4, 1.0 / 60, {}));
    twin.positions[20].x += 0.04F;
    CHECK(missedGradient(twin, [&](const std::vector<glm::vec4>& positions) {
            return sim::measureCloth(p, positions, std::vector<glm::vec4>(positions.size()), 0,
                                     twin.plan().softness())[4];
          }) < 2e-3);
  }
}

TEST_CASE("energy: energy-conserving face and attachment forces are the gradient of the measured energy") {
  sim::ClothParameters p = crumpled();
  p.fabric.emplace();
  p.mesh.emplace();
  p.mesh->size = glm::vec3(0.35F, 0, 0.5F);
  p.mesh->resolution = {6, 9};
  p.jitter = 0.012F;
  p.pins.emplace_back().vertices = {0, 1, 2};
  REQUIRE(p.keepsEnergy());
  GarmentTwin twin(sim::GarmentPlan("patch", p, 4, 1.0 / 60, {}));
  CHECK(!twin.plan().arrays().attachments.empty());
  CHECK(missedGradient(twin, [&](const std::vector<glm::vec4>& positions) {
          return sim::measureGarment(twin.plan(), positions, std::vector<glm::vec4>(positions.size()),
                                     0)[4];
        }) < 2e-3);
}

TEST_CASE("energy: sheets between pins conserve energy") {
  // In a straight line between two pins, one constraint is redundant.
  struct Held {
    const char* name;
    std::function<void(sim::PinGroup&)> pin;
  };
  for (const Held& held : {Held{"hammock",
                                [](sim::PinGroup& g) {
                                  g.rows = {0, -1};
                                }},
                           Held{"two corners",
                                [](sim::PinGroup& g) {
                                  g.corners = {0, 1};
                                }},
                           Held{"points", [](sim::PinGroup& g) {
                                  g.points = {{3, 4}, {9, 4}, {9, 15}};
                                }}}) {
    CAPTURE(held.name);
    auto given = swing::fabric(0, 0.05);
    sim::ClothParameters& p = given.parameters;
    p.rotation = glm::vec3(20, 0, 0);
    p.pins.clear();
    held.pin(p.pins.emplace_back());
    REQUIRE(p.keepsEnergy());
    ClothTwin twin(sim::ClothPlan(p, 1, 1.0 / 60, {}));
    const auto measure = [&] {
      return sim::measureCloth(p, twin.positions, twin.velocities, 0, twin.plan().softness());
    };
    const double first = measure()[5];
    double fastest = 0;
    double farthest = 0;
    for (int frame = 0; frame < 600; ++frame) {
      twin.step(frame / 60.0);
      const auto now = measure();
      fastest = std::max(fastest, now[2]);
      farthest = std::max(farthest, std::abs(now[5] - first));
    }
    CHECK(fastest > 1e-3);
    CHECK(farthest < 0.01 * fastest);
  }
}

TEST_CASE("energy: long undamped sheets hang and swing stably with substeps \"auto\"") {
  for (const double degrees : {0.0, 80.0}) {
    CAPTURE(degrees);
    auto given = swing::fabric(degrees, 0.02);
    sim::ClothParameters& p = given.parameters;
    p.size = {3, 256};
    given.length = 0.02 * 255;
    ClothTwin twin(sim::ClothPlan(p, 1, 1.0 / 60, {}));
    const auto energy = [&] {
      return sim::measureCloth(p, twin.positions, twin.velocities, 0, twin.plan().softness());
    };
    const double first = energy()[5];
    const double swing = energy()[1] * 9.8 * 0.5 * given.length;  // energy in J of the hanging cloth
                                                                  // relative to the horizontal cloth
    for (int frame = 0; frame < 120; ++frame) twin.step(frame / 60.0);
    CHECK(energy()[5] == doctest::Approx(first).epsilon(5e-3 * swing / std::abs(first)).scale(0));
    CHECK(energy()[6] < 1.02);
  }
}

TEST_CASE("energy: a fabric two columns wide, which cannot flutter, conserves energy for a minute") {
  auto given = swing::fabric(10, 0.1);
  given.parameters.size.x = 2;
  given.parameters.substeps = 16;
  const auto course = swing::courseOfTwin(given, 60);
  CHECK(std::abs(course.drift()) < 0.01);
  CHECK(course.rise < 3e-3);
}

TEST_CASE("energy: the mean energy of damped cloth over a swing does not rise") {
  // The cloth flutters with ever shorter waves, until the substeps cannot resolve the waves and the method
  // loses their energy.
  for (const bool mesh : {false, true})
    for (const double degrees : {10.0, 45.0}) {
      CAPTURE(mesh);
      CAPTURE(degrees);
      auto given = mesh ? swing::strip(degrees, 0.1) : swing::fabric(degrees, 0.1);
      given.parameters.damping = 1e-6F;
      given.parameters.substeps = 8;
      const auto course = swing::courseOfTwin(given, 60);
      CHECK(course.rise < 2e-3);
      if (degrees < 11) CHECK(course.drift() > -0.2);
    }
}
