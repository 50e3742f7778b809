// Tests contact of particles with each other through closed forms, conserved quantities and heaps. Uses the
// CPU twin, which equals the GPU bit for bit. All tests of this file take 6 s.
#include "base/error.hpp"
#include "unit/sim/balls_help.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace balls_friction {

constexpr double gravity = 9.81;

/// A plane through the origin that falls towards +x at `degrees`, and the directions along and off it.
struct Slope {
  double degrees, friction;
  [[nodiscard]] double radians() const { return degrees * M_PI / 180; }
  [[nodiscard]] glm::vec3 along() const { return {std::cos(radians()), -std::sin(radians()), 0}; }
  [[nodiscard]] glm::vec3 off() const { return {std::sin(radians()), std::cos(radians()), 0}; }
  [[nodiscard]] std::vector<sim::ColliderShape> plane() const {
    auto planes = balls::box(0, friction);
    planes[0].rotation = glm::vec3(0, 0, -degrees);
    return planes;
  }
  /// Returns the acceleration of a block along the slope in m/s^2 (Coulomb).
  [[nodiscard]] double acceleration() const {
    return gravity * std::max(0.0, std::sin(radians()) - friction * std::cos(radians()));
  }
};

sim::ParticleParameters onSlope(int count, double friction) {
  sim::ParticleParameters p = balls::parametersOf(count, 0, static_cast<float>(friction));
  p.acceleration = glm::vec3(0, -gravity, 0);
  p.autoSubsteps = true;
  p.collides = true;
  p.bounce = 0;
  p.margin = 0.05F;
  return p;
}

/// Returns the path in metres of the upper one of three balls that lie in a triangle on the ground, after a
/// quarter of a second.
double sinkOf(float friction, bool rolls) {
  sim::ParticleParameters p = onSlope(3, static_cast<double>(friction));
  p.contact->rolls = rolls;
  ParticlesTwin twin(sim::ParticlePlan(p, 1, balls::frame, 1 << 20, balls::box(0, double{friction})));
  const float up = 0.05F + 0.1F * std::sqrt(0.75F);
  const glm::vec3 at[] = {{-0.05F, 0.05F, 0}, {0.05F, 0.05F, 0}, {0, up, 0}};
  for (std::size_t i = 0; i < 3; ++i) {
    twin.positions[i] = glm::vec4(at[i], 1);
    twin.velocities[i] = glm::vec4(0);
  }
  balls::run(twin, 15);
  return static_cast<double>(up - twin.positions[2].y);
}

}  // namespace balls_friction

TEST_CASE("balls: an elastic head-on impact exchanges velocities by the closed form") {
  for (const float mass : {1.0F, 3.0F, 50.0F}) {
    CAPTURE(mass);
    auto twin = balls::placed({{{-0.2F, 0, 0}, {2, 0, 0}, mass}, {{0, 0, 0}, {0, 0, 0}, 1}},
                              balls::parametersOf(2, 1));
    balls::run(twin, 10);
    CHECK(twin.velocities[0].x == doctest::Approx(2 * (mass - 1) / (mass + 1)).epsilon(1e-4));
    CHECK(twin.velocities[1].x == doctest::Approx(4 * mass / (mass + 1)).epsilon(1e-4));
    // They meet at 0.05 s, within a substep.
    const double since = 10 * balls::frame - 0.05;
    CHECK(twin.positions[1].x == doctest::Approx(since * 4 * mass / (mass + 1)).epsilon(1e-4));
  }
}

TEST_CASE("balls: two balls part with the fraction e of their approach speed") {
  for (const float e : {0.0F, 0.5F, 0.9F}) {
    auto twin = balls::placed({{{-0.1F, 0, 0}, {1, 0, 0}, 2}, {{0.1F, 0, 0}, {-1, 0, 0}, 1}},
                              balls::parametersOf(2, e));
    balls::run(twin, 10);
    CHECK(twin.velocities[1].x - twin.velocities[0].x == doctest::Approx(2 * e).epsilon(1e-4));
    CHECK(balls::momentumOf(twin).x == doctest::Approx(1).epsilon(1e-5));
  }
}

TEST_CASE(
    "balls: an oblique elastic impact without friction changes velocities along the line of centres only") {
  auto twin = balls::placed({{{-0.2F, 0.05F, 0}, {3, 0, 0}, 1}, {{0, 0, 0}, {0, 0, 0}, 1}},
                            balls::parametersOf(2, 1));
  balls::run(twin, 8);
  const glm::dvec3 a(twin.velocities[0]), b(twin.velocities[1]);
  CHECK(balls::energyOf(twin) == doctest::Approx(4.5).epsilon(1e-4));
  CHECK(glm::length(balls::momentumOf(twin) - glm::dvec3(3, 0, 0)) < 1e-4);
  // Equal masses part at a right angle. The line of centres is at 30 degrees.
  CHECK(std::abs(glm::dot(a, b)) < 1e-3);
  CHECK(b.y / b.x == doctest::Approx(-std::sqrt(1.0 / 3)).epsilon(1e-4));
}

TEST_CASE("balls: the tangential impulse of a sliding impact is mu times the normal one") {
  for (const float mu : {0.1F, 0.3F}) {
    // The balls meet after 0.01 s, with the line of centres along x.
    auto twin = balls::placed({{{-0.1F, -0.005F, 0}, {1, 0.5F, 0}, 1}, {{0.01F, 0, 0}, {0, 0, 0}, 1}},
                              balls::parametersOf(2, 0.5F, mu));
    balls::run(twin, 6);
    CHECK(twin.velocities[1].x == doctest::Approx(0.75).epsilon(1e-4));
    CHECK(twin.velocities[1].y == doctest::Approx(0.75 * static_cast<double>(mu)).epsilon(1e-3));
    CHECK(balls::momentumOf(twin).y == doctest::Approx(0.5).epsilon(1e-4));
  }
}

TEST_CASE("balls: friction ends the sliding of an impact, and does not reverse it") {
  auto twin = balls::placed({{{-0.1F, -0.001F, 0}, {1, 0.1F, 0}, 1}, {{0.01F, 0, 0}, {0, 0, 0}, 1}},
                            balls::parametersOf(2, 0.5F, 0.9F));
  balls::run(twin, 6);
  CHECK(twin.velocities[0].y == doctest::Approx(0.05).epsilon(1e-3));
  CHECK(twin.velocities[1].y == doctest::Approx(0.05).epsilon(1e-3));
}

TEST_CASE("balls: of two impacts in a substep, the earlier one happens") {
  // The first ball stops at the second, before it would graze the third in the same substep.
  auto twin = balls::placed(
      {{{-0.105F, 0, 0}, {20, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}, {{-0.075F, 0.099F, 0}, {0, 0, 0}}},
      balls::parametersOf(3, 1));
  balls::run(twin, 1);
  CHECK(twin.velocities[1].x == doctest::Approx(20).epsilon(1e-4));
  CHECK(glm::length(glm::vec3(twin.velocities[2])) < 1e-3F);
}

TEST_CASE("balls: of two impacts at the same time, the faster one happens first") {
  auto twin =
      balls::placed({{{-0.0995F, 0, 0}, {1, 0, 0}}, {{0, 0, 0}, {0, 0, 0}}, {{0.0995F, 0, 0}, {-3, 0, 0}}},
                    balls::parametersOf(3, 0.5F));
  balls::run(twin, 1);
  // The middle ball has -2.25 m/s after the first impact, so the second one has 3.25 m/s.
  CHECK(twin.velocities[0].x == doctest::Approx(1 - 0.75 * 3.25).epsilon(1e-3));
}

TEST_CASE("balls: an approach that is too slow for an impact ends") {
  sim::ParticleParameters p = balls::parametersOf(2, 0.5F);
  p.acceleration = glm::vec3(0, -9.81F, 0);
  const float slow = 2.5F * 9.81F / 960;  // 2.5 times the speed of a fall of one substep
  auto twin = balls::placed({{{-0.1001F, 0, 0}, {slow, 0, 0}, 1}, {{0, 0, 0}, {0, 0, 0}, 1000}}, p);
  balls::run(twin, 2);
  CHECK(std::abs(twin.velocities[0].x) < 0.02F * slow);
}

TEST_CASE("balls: an approach that is too slow for an impact ends in the substep in which they touch") {
  sim::ParticleParameters p = balls::parametersOf(2, 0.5F);
  p.acceleration = glm::vec3(0, -9.81F, 0);
  const float slow = 2.9F * 9.81F / 960;
  auto twin = balls::placed({{{-0.10001F, 0, 0}, {slow, 0, 0}, 1}, {{0, 0, 0}, {0, 0, 0}, 1000}}, p);
  twin.beginFrame(0);
  twin.predict(0);
  CHECK(std::abs(twin.velocities[0].x) < 0.02F * slow);
}

TEST_CASE("balls: a cradle sends out as many balls as come in, with gaps and without") {
  for (const float gap : {0.0F, 0.002F})
    for (const int in : {1, 2}) {
      CAPTURE(gap);
      CAPTURE(in);
      std::vector<balls::Ball> row;
      for (int i = 0; i < 5; ++i)
        row.push_back({{(i < in ? -0.3F : 0) + (0.1F + gap) * static_cast<float>(i), 0, 0},
                       {i < in ? 1.0F : 0.0F, 0, 0}});
      auto twin = balls::placed(row, balls::parametersOf(5, 1));
      balls::run(twin, 40);
      for (int i = 0; i < 5; ++i)
        CHECK(std::abs(twin.velocities[static_cast<std::size_t>(i)].x - (i < 5 - in ? 0.0F : 1.0F)) <
              1e-3F);
    }
}

TEST_CASE("balls: a ball without rotation slides above the angle of friction, and rests below") {
  for (const double friction : {0.2, 0.5})
    for (const double beyond : {-3.0, -0.5, 0.5, 3.0, 15.0}) {
      const balls_friction::Slope slope{std::atan(friction) * 180 / M_PI + beyond, friction};
      CAPTURE(slope.degrees);
      ParticlesTwin twin(
          sim::ParticlePlan(balls_friction::onSlope(1, friction), 1, balls::frame, 1 << 20, slope.plane()));
      const glm::vec3 start = slope.off() * 0.05F;
      twin.positions[0] = glm::vec4(start, 1);
      balls::run(twin, 30);
      const double way = glm::dot(glm::vec3(twin.positions[0]) - start, slope.along());
      CHECK(std::abs(way - 0.125 * slope.acceleration()) < 1e-5 + 0.004 * 0.125 * slope.acceleration());
      CHECK(std::abs(glm::length(glm::vec3(twin.velocities[0])) - 0.5 * slope.acceleration()) < 1e-3);
    }
}

// Friction between the balls keeps the block together; friction of the slope acts on the lowest layer.
TEST_CASE("balls: a block of balls slides like one body above the angle of friction, and rests below") {
  for (const double beyond : {-4.0, 6.0}) {
    const balls_friction::Slope slope{std::atan(0.3) * 180 / M_PI + beyond, 0.3};
    CAPTURE(slope.degrees);
    sim::ParticleParameters p = balls_friction::onSlope(14, 0.3);
    p.contact->friction = 0.8F;
    ParticlesTwin twin(sim::ParticlePlan(p, 1, balls::frame, 1 << 20, slope.plane()));
    // Nine balls in a square carry four in its gaps, which carry one.
    std::vector<glm::vec3> places;
    for (int layer = 0; layer < 3; ++layer)
      for (int i = 0; i < (3 - layer) * (3 - layer); ++i) {
        const float side = 0.5F * static_cast<float>(2 - layer);
        const float x = static_cast<float>(i % (3 - layer)) - side,
                    z = static_cast<float>(i / (3 - layer)) - side;
        places.push_back(slope.along() * (0.1F * x) + glm::vec3(0, 0, 0.1F * z) +
                         slope.off() * (0.05F + 0.0707107F * static_cast<float>(layer)));
      }
    for (std::size_t i = 0; i < places.size(); ++i) {
      twin.positions[i] = glm::vec4(places[i], 1);
      twin.velocities[i] = glm::vec4(0);
    }
    balls::run(twin, 30);
    double way = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
      way += glm::dot(glm::vec3(twin.positions[i]) - places[i], slope.along()) / 14;
    CAPTURE(way);
    CHECK(std::abs(way - 0.125 * slope.acceleration()) < 0.001 + 0.05 * 0.125 * slope.acceleration());
  }
}

TEST_CASE("balls: each impact of a touching cradle passes on (1 + e) / 2 of the speed") {
  for (const float e : {0.9F, 0.5F}) {
    std::vector<balls::Ball> row;
    for (int i = 0; i < 5; ++i)
      row.push_back(
          {{(i == 0 ? -0.1F : 0) + 0.1F * static_cast<float>(i), 0, 0}, {i == 0 ? 1.0F : 0, 0, 0}});
    auto twin = balls::placed(row, balls::parametersOf(5, e));
    balls::run(twin, 12);
    CHECK(twin.velocities[4].x == doctest::Approx(std::pow(0.5 + 0.5 * e, 4)).epsilon(1e-4));
    CHECK(balls::momentumOf(twin).x == doctest::Approx(1).epsilon(1e-4));
    for (std::size_t i = 0; i < 4; ++i) CHECK(twin.velocities[i].x < twin.velocities[i + 1].x);
  }
}

TEST_CASE("balls: an elastic gas keeps its momentum and its energy") {
  std::vector<balls::Ball> gas;
  for (int i = 0; i < 125; ++i) {
    const auto bits = shader::hash3({static_cast<unsigned>(i), 4, 2});
    gas.push_back({glm::vec3(i % 5, i / 5 % 5, i / 25) * 0.11F, shader::signedUnits(bits) * 1.5F});
  }
  auto twin = balls::placed(gas, balls::parametersOf(125, 1));
  const double energy = balls::energyOf(twin);
  const glm::dvec3 momentum = balls::momentumOf(twin);
  balls::run(twin, 10);
  int turned = 0;
  for (std::size_t i = 0; i < gas.size(); ++i)
    turned += glm::distance(glm::vec3(twin.velocities[i]), gas[i].velocity) > 0.1F ? 1 : 0;
  CHECK(turned > 60);
  CHECK(balls::energyOf(twin) == doctest::Approx(energy).epsilon(1e-4));
  CHECK(glm::length(balls::momentumOf(twin) - momentum) < 1e-4);
}

// Each ball turns in 50 of the 60 frames; it takes 0.5 s.
TEST_CASE("balls: an elastic gas in a box keeps its energy over a hundred impacts of each ball") {
  sim::ParticleParameters p = balls::parametersOf(64, 1);
  p.collides = true;
  p.bounce = 1;
  p.margin = 0.05F;
  auto planes = balls::box(0.23F, 0);
  planes.emplace_back(planes[0]);
  planes.back().position = glm::vec3(0, 0.46F, 0);
  planes.back().rotation = glm::vec3(180, 0, 0);
  ParticlesTwin twin(sim::ParticlePlan(p, 1, balls::frame, 1 << 20, planes));
  for (std::size_t i = 0; i < 64; ++i) {
    const auto k = static_cast<int>(i);
    const auto bits = shader::hash3({static_cast<unsigned>(i), 4, 2});
    twin.positions[i] =
        glm::vec4(glm::vec3(k % 4, k / 4 % 4, k / 16) * 0.11F + glm::vec3(-0.165F, 0.065F, -0.165F), 1);
    twin.velocities[i] = glm::vec4(shader::signedUnits(bits) * 3.0F, 0);
  }
  const double energy = balls::energyOf(twin);
  long turned = 0;
  for (int frame = 0; frame < 60; ++frame) {
    const auto before = twin.velocities;
    twin.step(frame * balls::frame);
    for (std::size_t i = 0; i < 64; ++i) turned += before[i] != twin.velocities[i] ? 1 : 0;
  }
  CHECK(turned > 64 * 50);
  CHECK(balls::energyOf(twin) == doctest::Approx(energy).epsilon(0.002));
}

TEST_CASE("balls: a heap in a box comes to rest with overlaps below 1 % of the radius") {
  auto twin = balls::heap(400, 7, 0.4F, 0.37F, 125);
  const auto before = twin.positions;
  CHECK(balls::deepest(twin) < 0.01);
  balls::run(twin, 10);
  double moved = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    moved = std::max<double>(moved, glm::distance(glm::vec3(before[i]), glm::vec3(twin.positions[i])));
  CHECK(moved < 0.002);
  CHECK(balls::energyOf(twin) / 400 < 5e-5);  // energy per mass in J/kg, below the energy of a fall through
                                              // 5 micrometres
  for (const glm::vec4& p : twin.positions) CHECK(p.y > 0.049);
}

TEST_CASE("balls: the slope of a heap grows with friction") {
  double slopes[2];
  for (const int i : {0, 1}) {
    const auto twin = balls::heap(216, 6, i == 0 ? 0.1F : 0.8F, 0, 70);
    double height = 0, across = 0;
    for (const glm::vec4& p : twin.positions) {
      height += p.y - 0.05;
      across += std::hypot(p.x, p.z);
    }
    slopes[i] = height / across;
  }
  CAPTURE(slopes[0]);
  CAPTURE(slopes[1]);
  CHECK(slopes[1] > 3 * slopes[0]);
}

// A triangle of balls is the smallest pile; its sides have 60 degrees. Its lower balls are pushed apart by
// N (sin 30 - mu cos 30), N (cos 30 + mu sin 30) being half of a weight, and the ground holds 1.5 mu
// weights on each side. So balls without rotation stand if 1.5 mu^2 + 2 sqrt(3) mu >= 1/2. Balls that turn
// would roll away unless the friction at both contacts is equal, so that the torques cancel; it is N tan 15
// then. The rule for balls at rest also holds balls whose unbalanced force is below a tenth of the weight.
TEST_CASE(
    "balls: a triangle of three balls stands above mu = 0.136, or tan 15 degrees if they turn, and not at "
    "three tenths") {
  const double slides = (std::sqrt(15.0) - std::sqrt(12.0)) / 3, turns = std::tan(15 * M_PI / 180);
  for (const bool rolls : {false, true}) {
    CAPTURE(rolls);
    const double least = rolls ? turns : slides;
    CHECK(balls_friction::sinkOf(static_cast<float>(1.2 * least), rolls) < 0.001);
    CHECK(balls_friction::sinkOf(static_cast<float>(0.3 * least), rolls) > 0.01);
  }
}

TEST_CASE("balls: particles that overlap at the start are moved apart without speed") {
  const auto scene = balls::parsedScene(
      R"({"groups": [{"shape": "cube", "count": 200, "radius": 0.4}], "method": "none", "contact": {"radius": 0.05}})");
  const auto& p = dynamic_cast<const sim::ParticleParameters&>(*scene.objects[0].parameters);
  ParticlesTwin twin(sim::ParticlePlan(p, 1, balls::frame));
  CHECK(balls::deepest(twin) < 0.01);
  balls::run(twin, 5);
  CHECK(balls::energyOf(twin) < 1e-5);
}

// Positions that are written from outside are not moved apart before the first frame.
TEST_CASE("balls: balls that overlap by most of their radius part without speed") {
  std::vector<balls::Ball> pile;
  for (int i = 0; i < 64; ++i) {
    const auto bits = shader::hash3({static_cast<unsigned>(i), 4, 2});
    pile.push_back({glm::vec3(i % 4, i / 4 % 4, i / 16) * 0.07F + shader::signedUnits(bits) * 0.003F, {}});
  }
  auto twin = balls::placed(pile, balls::parametersOf(64, 0.3F, 0.4F));
  CHECK(balls::deepest(twin) > 0.6);
  balls::run(twin, 40);
  CHECK(balls::deepest(twin) < 0.04);
  for (const glm::vec4& v : twin.velocities) CHECK(glm::length(glm::vec3(v)) < 0.05F);
}

TEST_CASE("balls: two balls of unequal mass that overlap part about their centre of mass") {
  auto twin = balls::placed({{{0, 0, 0}, {0, 0, 0}, 3}, {{0.05F, 0, 0}, {0, 0, 0}, 1}},
                            balls::parametersOf(2, 0.3F));
  balls::run(twin, 2);
  const double first = twin.positions[0].x, second = twin.positions[1].x;
  CHECK(second - first == doctest::Approx(0.1).epsilon(1e-4));
  CHECK(3 * first + second == doctest::Approx(0.05).epsilon(1e-4));
  CHECK(glm::length(glm::vec3(twin.velocities[1])) < 1e-4F);
}

TEST_CASE("balls: particles that are born inside each other gain no energy") {
  const auto scene = balls::parsedScene(
      R"({"emitters": [{"rate": 200, "lifetime": 5}], "method": "none", "acceleration": [0, -9.8, 0],
          "contact": {"radius": 0.05}})");
  const auto& p = dynamic_cast<const sim::ParticleParameters&>(*scene.objects[0].parameters);
  ParticlesTwin twin(sim::ParticlePlan(p, 1, balls::frame));
  balls::run(twin, 30);
  float fastest = 0;
  for (std::size_t i = 0; i < twin.velocities.size(); ++i)
    if (twin.positions[i].w > 0) fastest = std::max(fastest, glm::length(glm::vec3(twin.velocities[i])));
  // The balls are emitted at 3 m/s, and fall for at most half a second.
  CHECK(fastest > 1);
  CHECK(fastest < 5);
  // Balls older than 0.3 s have their full radius, so no ball may be inside another.
  float nearest = 1;
  for (std::size_t i = 0; i < twin.positions.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (std::min(twin.velocities[i].w, twin.velocities[j].w) * 5 > 0.3F)
        nearest =
            std::min(nearest, glm::distance(glm::vec3(twin.positions[i]), glm::vec3(twin.positions[j])));
  CHECK(nearest > 0.09F);
}

TEST_CASE("balls: substeps and margin follow from the radius unless they are given") {
  const auto parametersOf = [](const std::string& more) {
    const auto scene = balls::parsedScene(
        R"({"groups": [{"count": 5}], "acceleration": [0, -10, 0], "collides": true, )" + more + "}",
        R"("ground": {}, )");
    return dynamic_cast<const sim::ParticleParameters&>(*scene.objects[0].parameters);
  };
  const auto own = parametersOf(R"("contact": true, "look": {"size": 0.1})");
  CHECK(own.margin == 0.05F);
  CHECK(own.contact->friction == 0.4F);
  CHECK(own.substepsPerFrame(1.0 / 60) == 18);
  CHECK(own.substepsPerFrame(1.0 / 120) == 9);
  const auto given = parametersOf(R"("contact": {"radius": 0.2}, "substeps": 2, "margin": 0.01)");
  CHECK(given.margin == 0.01F);
  CHECK(given.substepsPerFrame(1.0 / 60) == 2);
  CHECK_FALSE(parametersOf(R"("contact": false)").contact.has_value());
}

TEST_CASE("balls: groups that are too small and radii that differ too much are refused") {
  const auto lineOf = [](const std::string& object) -> std::string {
    try {
      const auto scene = balls::parsedScene(object);
      static_cast<void>(sim::ParticlePlan(
          dynamic_cast<const sim::ParticleParameters&>(*scene.objects[0].parameters), 1, balls::frame));
    } catch (const UserError& error) {
      CHECK(error.code() == ExitCode::usage);
      return error.what();
    }
    return "";
  };
  CHECK(lineOf(R"({"groups": [{"count": 1000, "radius": 0.2}], "contact": {"radius": 0.1}})")
            .find("1000 balls of radius 0.1 m do not fit into a group of radius 0.2 m; give it 1.26 m or "
                  "more") != std::string::npos);
  CHECK(lineOf(R"({"groups": [{"count": 1, "totalMass": 1}, {"count": 1, "totalMass": 1000}],
                   "look": {"massExponent": 1}, "contact": true})")
            .find("7 times is the most") != std::string::npos);
}
