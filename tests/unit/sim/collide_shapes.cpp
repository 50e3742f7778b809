// Tests collisions of particles with shapes by comparison with known results. The CPU twin equals the GPU
// bit for bit.
#include "reference/particles_twin.hpp"
#include "unit/sim/balls_help.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

constexpr double collideFrame = 1.0 / 60.0;

/// Returns one particle near a shape, with 16 substeps per frame. The default acceleration is 0.
ParticlesTwin oneBeside(const sim::ColliderShape& shape, const glm::vec3& position,
                        const glm::vec3& velocity, const glm::vec3& acceleration, float bounce,
                        float margin) {
  sim::ParticleParameters p;
  p.groups.emplace_back().count = 1;
  p.method = sim::GravityMethod::none;
  p.acceleration = acceleration;
  p.substeps = 16;
  p.collides = true;
  p.bounce = bounce;
  p.margin = margin;
  ParticlesTwin twin(sim::ParticlePlan(p, 1, collideFrame, 1 << 24, {shape}));
  twin.positions.assign(1, glm::vec4(position, 1));
  twin.velocities.assign(1, glm::vec4(velocity, 0));
  return twin;
}

sim::ColliderShape smoothShape(sim::ColliderShape::Kind kind, float radius) {
  sim::ColliderShape shape;
  shape.kind = kind;
  shape.radius = radius;
  shape.grip = 0;
  return shape;
}

}  // namespace

TEST_CASE("collide: a particle reflects off a capsule and loses energy by its bounce factor") {
  auto rod = smoothShape(sim::ColliderShape::Kind::capsule, 0.3F);
  rod.length = 2;
  rod.rotation = glm::vec3(0, 0, 90);  // The rotation turns the rod's axis to x.
  for (const float bounce : {1.0F, 0.5F, 0.0F}) {
    CAPTURE(bounce);
    // The particle hits the sphere at the point with the normal (0, 0.8, 0.6).
    const glm::dvec3 n(0, 0.8, 0.6);
    const glm::dvec3 v(0.7, -3, 0.4);
    const glm::dvec3 start = n * 0.35 - v * 0.05;
    auto twin = oneBeside(rod, glm::vec3(start), glm::vec3(v), glm::vec3(0), bounce, 0.05F);
    for (int frame = 0; frame < 12; ++frame) twin.step(frame * collideFrame);
    const glm::dvec3 expected = v - (1.0 + bounce) * glm::dot(v, n) * n;
    // The penetration in the substep before the contact changes the direction of the normal slightly.
    CHECK(glm::length(glm::dvec3(twin.velocities[0]) - expected) < 0.03);
    if (bounce == 1) CHECK(glm::length(glm::dvec3(twin.velocities[0])) == doctest::Approx(glm::length(v)));
  }
}

TEST_CASE("collide: impact friction takes mu (1 + e) of the normal speed") {
  for (const float bounce : {0.0F, 0.5F, 1.0F}) {
    CAPTURE(bounce);
    auto ground = smoothShape(sim::ColliderShape::Kind::plane, 0);
    ground.friction = 0.2;
    auto twin = oneBeside(ground, {0, 0.1F, 0}, {2, -3, 0}, glm::vec3(0), bounce, 0.02F);
    for (int frame = 0; frame < 3; ++frame) twin.step(frame * collideFrame);
    CHECK(twin.velocities[0].x == doctest::Approx(2 - 0.2 * (1 + bounce) * 3).epsilon(1e-5));
    CHECK(twin.velocities[0].y == doctest::Approx(3 * bounce).epsilon(1e-5));
  }
}

TEST_CASE("collide: a particle on a slope sticks below the friction angle and slides above it") {
  for (const double degrees : {20.0, 35.0}) {
    CAPTURE(degrees);
    auto slope = smoothShape(sim::ColliderShape::Kind::plane, 0);
    slope.rotation = glm::vec3(0, 0, degrees);
    slope.friction = 0.5;  // friction coefficient, the tangent of 26.6 degrees
    const double angle = degrees * M_PI / 180;
    const glm::dvec3 normal(-std::sin(angle), std::cos(angle), 0);
    auto twin = oneBeside(slope, glm::vec3(normal * 0.02), glm::vec3(0), {0, -9.81F, 0}, 0, 0.02F);
    for (int frame = 0; frame < 60; ++frame) twin.step(frame * collideFrame);
    const double way = glm::length(glm::dvec3(twin.positions[0]) - normal * 0.02);
    const double theory = 0.5 * 9.81 * (std::sin(angle) - 0.5 * std::cos(angle));
    if (degrees < 26)
      CHECK(way < 1e-5);
    else
      CHECK(std::abs(way - theory) < 0.01 * theory);
  }
}

TEST_CASE("collide: a moving ball carries a particle, and a non-colliding ball has no effect") {
  auto ball = smoothShape(sim::ColliderShape::Kind::sphere, 0.5F);
  ball.position =
      scene::Animated<glm::vec3>({{0.0, glm::vec3(0)}, {1.0, glm::vec3(0, 2, 0)}}, scene::Ease::linear);
  auto twin = oneBeside(ball, {0, 0.6F, 0}, glm::vec3(0), glm::vec3(0), 0, 0.05F);
  for (int frame = 0; frame < 30; ++frame) twin.step(frame * collideFrame);
  CHECK(twin.positions[0].y == doctest::Approx(1 + 0.55).epsilon(1e-3));
  CHECK(twin.velocities[0].y == doctest::Approx(2).epsilon(1e-3));
  sim::ParticleParameters free = twin.plan().parameters();
  free.collides = false;
  CHECK(sim::ParticlePlan(free, 1, collideFrame, 1 << 24, {ball}).colliderCount() == 0);
}

// The moment of inertia 2/5 m R^2 leaves 5/7 of the acceleration of a block without friction. A slope that
// is too steep for the friction lets the ball slide and turn: its acceleration is g (sin a - mu cos a).
TEST_CASE(
    "balls: a ball that turns rolls down a slope with 5/7 g sin a, or slides if friction is too low") {
  for (const double friction : {0.5, 0.1}) {
    const double angle = 30 * M_PI / 180, gravity = 9.81;
    sim::ParticleParameters p = balls::parametersOf(1, 0, 0.5F);
    p.contact->rolls = true;
    p.acceleration = glm::vec3(0, -gravity, 0);
    p.autoSubsteps = true;
    p.collides = true;
    p.bounce = 0;
    p.margin = 0.05F;
    auto planes = balls::box(0, friction);
    planes[0].rotation = glm::vec3(0, 0, -30);
    ParticlesTwin twin(sim::ParticlePlan(p, 1, balls::frame, 1 << 20, planes));
    const glm::vec3 off(std::sin(angle), std::cos(angle), 0), along(std::cos(angle), -std::sin(angle), 0);
    twin.positions[0] = glm::vec4(off * 0.05F, 1);
    balls::run(twin, 30);
    const double rolling = gravity * std::sin(angle) * 5 / 7,
                 sliding = gravity * (std::sin(angle) - friction * std::cos(angle)),
                 acceleration = std::max(rolling, sliding),
                 turning = std::min(rolling, 2.5 * friction * gravity * std::cos(angle)) / 0.05;
    CHECK(glm::dot(glm::vec3(twin.velocities[0]), along) ==
          doctest::Approx(0.5 * acceleration).epsilon(2e-3));
    CHECK(glm::dot(glm::vec3(twin.positions[0]), along) ==
          doctest::Approx(0.125 * acceleration).epsilon(5e-3));
    CHECK(twin.spins[0].z == doctest::Approx(-0.5 * turning).epsilon(2e-3));
    // The orientation is a unit quaternion of the angle that the ball has turned.
    const glm::vec4& turn = twin.turns[0];
    CHECK(glm::length(turn) == doctest::Approx(1).epsilon(1e-6));
    const double turned = 0.125 * turning;
    CHECK(std::abs(turn.w) == doctest::Approx(std::abs(std::cos(turned / 2))).epsilon(0.01));
    CHECK(std::abs(turn.z) == doctest::Approx(std::abs(std::sin(turned / 2))).epsilon(0.01));
  }
}

TEST_CASE("balls: an oblique impact turns both balls the same way, and keeps the angular momentum") {
  for (const float mu : {0.05F, 2.0F}) {
    sim::ParticleParameters p = balls::parametersOf(2, 1, mu);
    p.contact->rolls = true;
    auto twin = balls::placed({{{-0.1F, -0.005F, 0}, {1, 0.5F, 0}, 1}, {{0.01F, 0, 0}, {0, 0, 0}, 1}}, p);
    balls::run(twin, 6);
    // Tangential impulse: 2/7 of the sliding speed of two equal masses if the contact grips, else mu times
    // the normal one.
    const double impulse = std::min(0.5 * 0.5 * 2 / 7, static_cast<double>(mu));
    CHECK(twin.velocities[1].y == doctest::Approx(impulse).epsilon(2e-3));
    CHECK(balls::momentumOf(twin).y == doctest::Approx(0.5).epsilon(1e-4));
    CHECK(twin.spins[0].z == doctest::Approx(-2.5 * impulse / 0.05).epsilon(2e-3));
    CHECK(twin.spins[1].z == doctest::Approx(twin.spins[0].z).epsilon(1e-4));
  }
}

TEST_CASE("balls: a ball that lies on the ground between balls does not turn") {
  sim::ParticleParameters p = balls::parametersOf(3, 0, 0.5F);
  p.contact->rolls = true;
  p.acceleration = glm::vec3(0, -9.81F, 0);
  p.autoSubsteps = true;
  p.collides = true;
  p.margin = 0.05F;
  ParticlesTwin twin(sim::ParticlePlan(p, 1, balls::frame, 1 << 20, balls::box(0, 0.5)));
  for (std::size_t i = 0; i < 3; ++i)
    twin.positions[i] = glm::vec4(0.1F * static_cast<float>(i), 0.05F, 0, 1);
  balls::run(twin, 20);
  for (const glm::vec4& spin : twin.spins) CHECK(glm::length(glm::vec3(spin)) < 0.02F);
}
