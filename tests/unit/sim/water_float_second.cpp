// Tests a step of a float by comparison with an independent implementation in double precision that uses
// rotation matrices and plain division. Also tests the exchange of momentum between water and float.
#include "reference/water_twin.hpp"
#include "sim/core/collider.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

constexpr double driftFrame = 1.0 / 30;
using Axes = std::array<glm::dvec3, 3>;  ///< the columns of a rotation matrix

double inner(const glm::dvec3& a, const glm::dvec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
glm::dvec3 outer(const glm::dvec3& a, const glm::dvec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Axes axesOf(const glm::dvec4& q) {
  const auto turned = [&](const glm::dvec3& v) {
    const glm::dvec3 u(q.x, q.y, q.z);
    return 2 * inner(u, v) * u + (q.w * q.w - inner(u, u)) * v + 2 * q.w * outer(u, v);
  };
  return {turned({1, 0, 0}), turned({0, 1, 0}), turned({0, 0, 1})};
}
glm::dvec3 out(const Axes& r, const glm::dvec3& v) {
  return r[0] * v.x + r[1] * v.y + r[2] * v.z;
}
glm::dvec3 back(const Axes& r, const glm::dvec3& v) {
  return {inner(r[0], v), inner(r[1], v), inner(r[2], v)};
}

/// Water with a constant slope and velocity. `u` and `w` are the velocity along x and z.
struct Stream {
  double level, slopeX, slopeZ, u, w, bed;
  [[nodiscard]] double at(double x, double z) const { return level + slopeX * x + slopeZ * z; }
};

struct Drifting {
  glm::dvec3 at{0}, velocity{0}, spin{0};
  Axes axes{};
  double level = 0;
  glm::dvec2 stages{0};
};

struct Drift {
  Drifting next;
  glm::dvec3 push{0};  ///< force (N) of the water on the float, which acts in reverse on the water
  double displaced = 0;
  double wet = 0;  ///< submerged volume, m^3
};

/// Performs a step as described in src/sim/water/README.md.
Drift stepped(const sim::WaterParameters& p, const sim::Hull& hull, const Stream& stream,
              const Drifting& now, double under, double dt, double share, double time) {
  constexpr double rho = 1000;
  const sim::WaterFloat& body = p.floats[0];
  const double g = p.gravity;
  const glm::dvec3 turning = out(now.axes, [&] {
    const glm::dvec3 own = back(now.axes, now.spin);
    const auto m = hull.inverseInertia();
    return glm::dvec3(m[0] * own.x + m[3] * own.y + m[4] * own.z,
                      m[3] * own.x + m[1] * own.y + m[5] * own.z,
                      m[4] * own.x + m[5] * own.y + m[2] * own.z);
  }());
  const double tall = std::abs(now.axes[0].y) * hull.grain.x + std::abs(now.axes[1].y) * hull.grain.y +
                      std::abs(now.axes[2].y) * hull.grain.z;
  const double lighter = rho * hull.volume / hull.mass;
  // The steering moment is made of sideways forces proportional to the distance from the mast.
  double spread = 0;
  for (const glm::vec4& point : hull.points)
    spread += static_cast<double>(point.w) *
              (static_cast<double>(point.x) * point.x + static_cast<double>(point.z) * point.z);
  const double steered = static_cast<double>(body.steering.at(time)) * hull.volume / spread;
  Drift result;
  glm::dvec3 force(0), moment(0);
  double around = 0, risen = 0;
  for (const glm::vec4& point : hull.points) {
    const glm::dvec3 arm = out(now.axes, glm::dvec3(point)), place = now.at + arm;
    const double volume = point.w, level = stream.at(place.x, place.z);
    const double wet = std::clamp((level - place.y) / tall + 0.5, 0.0, 1.0);
    glm::dvec3 own = rho * g * volume * wet * glm::dvec3(-stream.slopeX, 1, -stream.slopeZ);
    // The keel increases the resistance to the sideways part of the motion.
    glm::dvec3 past = now.velocity + outer(turning, arm) - glm::dvec3(stream.u, 0, stream.w);
    past += (body.keel - 1.0) * inner(past, now.axes[0]) * now.axes[0];
    const double pace = (body.drag * lighter + 0.5 * body.resistance * 0.25 * hull.area / hull.volume *
                                                   lighter * std::sqrt(inner(past, past))) *
                        wet;
    const double laden = 1 + hull.mass / (hull.outline * rho) / (level - stream.bed);
    own -= hull.mass * volume / hull.volume * pace / (1 + pace * dt * laden * body.keel) * past;
    const double within = volume * std::clamp((now.level - place.y) / tall + 0.5, 0.0, 1.0);
    const double works = volume * wet;
    own += works / under * steered * outer(now.axes[1], arm);
    force += own;
    moment += outer(arm, own);
    result.push += own + static_cast<double>(body.thrust.at(time)) * works / under * now.axes[2];
    around += within;
    result.wet += works;
    risen += volume * (level - now.level);
  }
  result.displaced = around;
  force += static_cast<double>(body.thrust.at(time)) * result.wet / under * now.axes[2];
  if (body.tow) {
    const glm::dvec3 target(body.tow->position.at(time));
    const glm::dvec3 pace = (glm::dvec3(body.tow->position.at(time + driftFrame)) - target) / driftFrame;
    const double k = body.tow->pull;
    const auto pulled = [&](int i) {
      return hull.mass * (k * k * (target[i] - now.at[i]) + 2 * k * (pace[i] - now.velocity[i]));
    };
    force += glm::dvec3(pulled(0), 0, pulled(2));
    const double length = std::sqrt(pace.x * pace.x + pace.z * pace.z);
    // sine of the angle from the bow to the direction of motion, about y; its magnitude is 1 for backward
    // motion
    double off = (now.axes[2].z * pace.x - now.axes[2].x * pace.z) / length;
    if (now.axes[2].z * pace.z + now.axes[2].x * pace.x < 0) off = off < 0 ? -1 : 1;
    moment.y += hull.inertia[1] * (k * k * off - 2 * k * turning.y);
  }
  const double airy = 1 / (1 + dt * body.air * std::max(hull.volume - result.wet, 0.0) / hull.volume);
  Drifting& next = result.next;
  next.velocity = (now.velocity + dt * force / hull.mass - glm::dvec3(0, dt * g, 0)) * airy;
  next.at = now.at + dt * next.velocity;
  next.spin = (now.spin + dt * moment) * airy;
  const double over = now.level + risen / hull.volume;
  next.stages = now.stages + share * (glm::dvec2(over, now.stages.x) - now.stages);
  next.level = now.level + share * (now.stages.y - now.level);
  // The body rotates by the angular velocity of the new angular momentum for the time dt (Rodrigues).
  const auto m = hull.inverseInertia();
  const glm::dvec3 own = back(now.axes, next.spin);
  const glm::dvec3 rate =
      out(now.axes, {m[0] * own.x + m[3] * own.y + m[4] * own.z, m[3] * own.x + m[1] * own.y + m[5] * own.z,
                     m[4] * own.x + m[5] * own.y + m[2] * own.z});
  const double angle = std::sqrt(inner(rate, rate)) * dt;
  const glm::dvec3 axis = rate * (dt / std::max(angle, 1e-12));
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3 v = now.axes[static_cast<std::size_t>(i)];
    next.axes[static_cast<std::size_t>(i)] = std::cos(angle) * v + std::sin(angle) * outer(axis, v) +
                                             (1 - std::cos(angle)) * inner(axis, v) * axis;
  }
  return result;
}

void fillStream(WaterTwin& twin, const Stream& stream) {
  const sim::WaterParameters& p = twin.plan().parameters();
  std::size_t i = 0;
  for (int y = 0; y < p.size.y; ++y)
    for (int x = 0; x < p.size.x; ++x, ++i) {
      const double level =
          stream.at((x + 0.5 - 0.5 * p.size.x) * p.cell, (y + 0.5 - 0.5 * p.size.y) * p.cell);
      const double depth = level - stream.bed;
      twin.cells[i] = glm::vec4(glm::dvec4(level, depth * stream.u, depth * stream.w, stream.bed));
    }
}

glm::dvec2 waterMomentum(const WaterTwin& twin) {
  const double area = static_cast<double>(twin.plan().parameters().cell) * twin.plan().parameters().cell;
  glm::dvec2 sum(0);
  for (const glm::vec4& c : twin.cells) sum += 1000 * area * glm::dvec2(c.y, c.z);
  return sum;
}

sim::WaterParameters driftTank(int cells, float cell, float deep) {
  sim::WaterParameters p;
  p.size = {cells, cells};
  p.cell = cell;
  p.bed = -deep;
  p.greatestSpeed = 3;
  return p;
}

sim::WaterFloat driftBox(glm::vec3 size, float density) {
  sim::WaterFloat body;
  body.shape = sim::WaterFloatShape::box;
  body.size = size;
  body.density = density;
  return body;
}

}  // namespace

TEST_CASE("water floats: a step equals its equations in double precision") {
  auto p = driftTank(36, 0.2F, 2.5F);
  auto body = driftBox({0.6F, 0.4F, 1.3F}, 600);
  body.ballast = {0.03F, -0.05F, 0.1F};
  body.drag = 0.4F;
  body.resistance = 0.8F;
  body.keel = 4;
  body.air = 3;
  body.thrust = 250.0F;
  body.steering = -40.0F;
  body.rotation = {8, 35, -17};
  body.velocity = {0.7F, -0.3F, 0.45F};
  body.spin = {50, -35, 70};
  body.position = {0.3F, 0.02F, -0.2F};
  for (const float way : {0.0F, 1.1F, -1.1F}) {
    CAPTURE(way);
    body.tow.reset();
    if (way != 0)
      body.tow.emplace().position = scene::Animated<glm::vec3>(
          {{0, {0.9F, 0, 0.1F}}, {1, {2.2F, 0, 0.1F + way}}}, scene::Ease::linear);
    p.floats = {body};
    WaterTwin twin(sim::WaterPlan(p, "tank", 1, driftFrame));
    const Stream stream{0.04, 0.03, -0.02, 0.35, -0.2, -2.5};
    fillStream(twin, stream);
    Drifting now;
    now.at = glm::dvec3(twin.floats[0]);
    now.level = twin.floats[0].w;
    now.axes = axesOf(glm::dvec4(twin.floats[1]));
    now.velocity = glm::dvec3(twin.floats[2]);
    now.spin = glm::dvec3(twin.floats[3]);
    // The stored values of the filter differ, so that an error in any stage is noticed.
    twin.floats[4].x = 0.3F;
    twin.floats[4].y = -0.2F;
    now.stages = {0.3, -0.2};
    const double under = twin.floats[4].w, dt = twin.plan().stepSeconds();
    const sim::Hull& hull = twin.plan().floats().hulls()[0];
    const double share = dt / (2 / (std::numbers::pi * std::sqrt(9.81 * 2.5) / (36 * 0.2)));
    const Drift want = stepped(p, hull, stream, now, under, dt, share, 0);
    const glm::dvec2 before = waterMomentum(twin);
    twin.drift(0, 0);
    const glm::dvec3 gained = (glm::dvec3(twin.floats[2]) - now.velocity) / dt;
    const glm::dvec3 wanted = (want.next.velocity - now.velocity) / dt;
    const glm::dvec3 spun = (glm::dvec3(twin.floats[3]) - now.spin) / dt;
    const glm::dvec3 toSpin = (want.next.spin - now.spin) / dt;
    const Axes axes = axesOf(glm::dvec4(twin.floats[1]));
    double turned = 0;
    for (std::size_t i = 0; i < 3; ++i)
      turned = std::max(turned, std::sqrt(inner(axes[i] - want.next.axes[i], axes[i] - want.next.axes[i])));
    const double force = std::sqrt(inner(wanted, wanted)), torque = std::sqrt(inner(toSpin, toSpin));
    const double offForce = std::sqrt(inner(gained - wanted, gained - wanted)) / force;
    const double offTorque = std::sqrt(inner(spun - toSpin, spun - toSpin)) / torque;
    MESSAGE("force off by ", offForce, ", moment by ", offTorque, ", axes by ", turned);
    CHECK(force > 0.5);
    CHECK(torque > 10);
    CHECK(offForce < 2e-4);
    CHECK(offTorque < 2e-4);
    CHECK(turned < 2e-6);
    for (int i = 0; i < 3; ++i) CHECK(std::abs(twin.floats[0][i] - want.next.at[i]) < 1e-6);
    CHECK(twin.floats[0].w == doctest::Approx(want.next.level).epsilon(1e-5));
    CHECK(twin.floats[2].w == doctest::Approx(want.displaced).epsilon(1e-5));
    for (int i = 0; i < 2; ++i) CHECK(std::abs(twin.floats[4][i] - want.next.stages[i]) < 1e-6);
    CHECK(twin.floats[4].w == doctest::Approx(want.wet).epsilon(1e-5));
    // The towing force does not act on the water.
    const glm::dvec2 given = waterMomentum(twin) - before;
    CHECK(given.x == doctest::Approx(-want.push.x * dt).epsilon(1e-3));
    CHECK(given.y == doctest::Approx(-want.push.z * dt).epsilon(1e-3));
    double displaced = 0;
    for (const glm::ivec4& sum : twin.displaced)
      displaced += sum.w * static_cast<double>(twin.plan().floats().step().depthUnit) * 0.04;
    CHECK(displaced == doctest::Approx(want.displaced).epsilon(1e-4));
  }
}

TEST_CASE("water floats: a heeled box is righted by the wall-sided formula") {
  // While no corner enters or leaves the water, the righting lever at the heel angle a is GZ = sin a (GM +
  // BM tan^2 a / 2). BM = b^2 / (12 T) and GM = T / 2 + BM - KG, with breadth b, draft T and height KG of
  // the centre of mass above the keel.
  auto p = driftTank(40, 0.2F, 3);
  for (const float low : {0.0F, -0.12F})
    for (const float angle : {4.0F, 10.0F, 18.0F, -10.0F}) {
      CAPTURE(angle);
      auto body = driftBox({1.6F, 0.8F, 1.2F}, 450);
      body.ballast = {0, low, 0};
      const double draft = 0.8 * 0.45, a = angle * std::numbers::pi / 180;
      const double heavy = 0.4 + low - draft;  // height of the centre of mass above the water when the box
                                               // is upright
      // The origin of the shape is placed so that the box heels about the middle of its waterline. The
      // displaced volumes are then equal.
      const double middle = 0.4 - draft;
      body.position = {static_cast<float>(-middle * std::sin(a)), static_cast<float>(middle * std::cos(a)),
                       0};
      body.rotation = {0, 0, angle};
      p.floats = {body};
      WaterTwin twin(sim::WaterPlan(p, "tank", 1, driftFrame));
      CHECK(twin.floats[0].y == doctest::Approx(heavy * std::cos(a)).epsilon(1e-3));
      twin.drift(0, 0);
      const double weight = 1000 * 9.81 * 1.6 * 1.2 * draft;
      const double metacentre = 1.6 * 1.6 / (12 * draft);
      const double arm = std::sin(a) * (draft / 2 + metacentre - (0.4 + low) +
                                        0.5 * metacentre * std::tan(a) * std::tan(a));
      const double moment = twin.floats[3].z / twin.plan().stepSeconds();
      CHECK(moment == doctest::Approx(-weight * arm).epsilon(0.03));
      CHECK(std::abs(twin.floats[2].y) / twin.plan().stepSeconds() < 0.05);
    }
}

TEST_CASE("water floats: a freely tumbling body conserves momentum and energy") {
  // The body rotates in air. By Euler's equations, the angular momentum L and the energy L.w / 2 are
  // constant.
  auto p = driftTank(12, 0.5F, 1);
  auto body = driftBox({0.3F, 0.5F, 1.1F}, 300);
  body.position = {0, 60, 0};
  body.spin = {90, 200, 60};
  p.floats = {body};
  p.substeps = 16;
  WaterTwin twin(sim::WaterPlan(p, "tank", 1, driftFrame));
  const sim::Hull& hull = twin.plan().floats().hulls()[0];
  const auto energy = [&] {
    const Axes r = axesOf(glm::dvec4(twin.floats[1]));
    const glm::dvec3 own = back(r, glm::dvec3(twin.floats[3]));
    return 0.5 * (own.x * own.x / hull.inertia[0] + own.y * own.y / hull.inertia[1] +
                  own.z * own.z / hull.inertia[2]);
  };
  const double before = energy();
  const glm::vec4 spin = twin.floats[3];
  for (int i = 0; i < 60; ++i) twin.step(i * driftFrame);
  MESSAGE("energy ", energy() / before);
  CHECK(twin.floats[3] == spin);
  CHECK(energy() == doctest::Approx(before).epsilon(0.03));
  CHECK(static_cast<double>(twin.floats[2].y) == doctest::Approx(-9.81 * 2).epsilon(1e-4));
}

TEST_CASE("water floats: in a closed tank, engine and drag forces on a body act oppositely on the water") {
  for (const bool walls : {true, false}) {
    auto p = driftTank(56, 0.4F, 1);
    if (!walls) p.sides.fill(sim::WaterBorder::periodic);
    auto body = driftBox({0.7F, 0.4F, 1.4F}, 500);
    body.thrust = 400.0F;
    body.rotation = {0, 35, 0};
    body.velocity = {0, 0, 0.8F};
    body.keel = 3;
    p.floats = {body};
    WaterTwin twin(sim::WaterPlan(p, "tank", 1, driftFrame));
    const double mass = twin.plan().floats().hulls()[0].mass;
    const auto all = [&] {
      return glm::dvec2(mass * twin.floats[2].x, mass * twin.floats[2].z) + waterMomentum(twin);
    };
    const glm::dvec2 before = all();
    // The waves take 3 s to reach the walls.
    const int frames = 60;
    for (int i = 0; i < frames; ++i) twin.step(i * driftFrame);
    const double impulse = 400 * frames * driftFrame;
    const glm::dvec2 off = all() - before;
    MESSAGE("off by ", std::max(std::abs(off.x), std::abs(off.y)) / impulse, " of the engine's impulse");
    CHECK(mass * twin.floats[2].x > 0.1 * impulse);
    CHECK(std::abs(off.x) < 1e-5 * impulse);
    CHECK(std::abs(off.y) < 1e-5 * impulse);
  }
}

TEST_CASE("water floats: steering torque on a body acts oppositely on the water") {
  auto p = driftTank(64, 0.2F, 1);
  auto body = driftBox({0.8F, 0.4F, 1.6F}, 500);
  body.rotation = {0, 35, 0};
  body.steering = 60.0F;
  p.floats = {body};
  WaterTwin twin(sim::WaterPlan(p, "tank", 1, driftFrame));
  const double mass = twin.plan().floats().hulls()[0].mass;
  // angular momentum z p_x - x p_z about the y axis through the grid's middle
  const auto ofWater = [&] {
    double sum = 0;
    for (int y = 0, i = 0; y < p.size.y; ++y)
      for (int x = 0; x < p.size.x; ++x, ++i) {
        const double atX = (x + 0.5 - 0.5 * p.size.x) * 0.2, atZ = (y + 0.5 - 0.5 * p.size.y) * 0.2;
        const glm::dvec4 cell(twin.cells[static_cast<std::size_t>(i)]);
        sum += 1000 * 0.04 * (atZ * cell.y - atX * cell.z);
      }
    return sum;
  };
  const auto ofBody = [&] {
    const glm::dvec3 at(twin.floats[0]), v(twin.floats[2]);
    return static_cast<double>(twin.floats[3].y) + mass * (at.z * v.x - at.x * v.z);
  };
  const double dt = twin.plan().stepSeconds();
  twin.drift(0, 0);
  MESSAGE("in a step ", ofBody() / (60 * dt), " of the moment, the water ", ofWater() / (60 * dt));
  CHECK(ofBody() == doctest::Approx(60 * dt).epsilon(0.02));
  CHECK(ofWater() == doctest::Approx(-ofBody()).epsilon(0.01));
  for (int i = 0; i < 30; ++i) twin.step(i * driftFrame);
  MESSAGE("in a second ", ofBody() / 60, ", the water ", ofWater() / 60);
  CHECK(ofBody() > 6);
  CHECK(std::abs(ofBody() + ofWater()) < 0.05 * 60);
  const glm::dvec2 along = waterMomentum(twin);
  CHECK(std::abs(along.x) + std::abs(along.y) < 1);
}
