// Tests a fluid that is used as wind, by comparison with closed forms.
#include "base/error.hpp"
#include "reference/cloth_twin.hpp"
#include "reference/particles_twin.hpp"
#include "reference/spread_twin.hpp"
#include "scene/load.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/world/list.hpp"
#include "unit/help.hpp"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

/// Returns a wind whose velocities u and v are functions of the position in the fluid (cells).
template <class Velocity>
WindTwin windOf(const sim::FluidPlane& plane, glm::ivec2 size, const Velocity& velocity) {
  WindTwin wind{sim::fluidWindGrid(plane, size)};
  for (int y = -1; y <= size.y; ++y)
    for (int x = -1; x <= size.x; ++x)
      wind.flow.emplace_back(velocity(glm::dvec2(x, y + 0.5)).x, velocity(glm::dvec2(x + 0.5, y)).y, 0, 0);
  return wind;
}

/// Returns particles at rest at these positions that only the wind affects.
ParticlesTwin seedsIn(const WindTwin& wind, const std::vector<glm::vec3>& places, float drag,
                      float damping) {
  sim::ParticleParameters p;
  p.method = sim::GravityMethod::none;
  p.damping = damping;
  p.wind.emplace();
  p.wind->fluid = "storm";
  p.wind->drag = drag;
  p.groups.resize(1);
  p.groups[0].count = static_cast<int>(places.size());
  ParticlesTwin twin(sim::ParticlePlan(p, 1, 1.0 / 60));
  for (std::size_t i = 0; i < places.size(); ++i) {
    twin.positions[i] = glm::vec4(places[i], 1);
    twin.velocities[i] = glm::vec4(0);
  }
  twin.wind = wind;
  return twin;
}

}  // namespace

// For a particle that starts at rest, v' = d (w - v) - c v, with drag d, damping c and wind w. The solution
// is v = w d / r (1 - e^(-r t)), x = w d / r (t - (1 - e^(-r t)) / r) with r = c + d.
TEST_CASE("fluid wind: a particle in a uniform flow approaches its speed as the closed form does") {
  sim::FluidPlane plane;
  plane.position = {1, 2, -3};
  plane.cell = 0.25F;
  const WindTwin wind = windOf(plane, {41, 30}, [](glm::dvec2) { return glm::dvec2(8, -6); });
  const double drag = 3, damping = 0.5, rate = drag + damping;
  ParticlesTwin seeds = seedsIn(wind, {{0, 1, -3}, {-1, 0, 40}, {30, 1, -3}}, 3, 0.5F);
  const std::vector<glm::vec4> before = seeds.positions;
  for (int frame = 0; frame < 45; ++frame) seeds.step(frame / 60.0);
  const double t = 45 / 60.0, kept = std::exp(-rate * t);
  const glm::dvec3 terminal = glm::dvec3(8, 6, 0) * 0.25 * drag / rate;  // terminal velocity in m/s
  for (const std::size_t i : {0U, 1U})
    for (int axis = 0; axis < 3; ++axis) {
      CAPTURE(i);
      CAPTURE(axis);
      const double moved = seeds.positions[i][axis] - before[i][axis];
      CHECK(std::abs(seeds.velocities[i][axis] - terminal[axis] * (1 - kept)) < 2e-6);
      CHECK(std::abs(moved - terminal[axis] * (t - (1 - kept) / rate)) < 5e-6);
    }
  // Outside the rectangle the air is still.
  CHECK(glm::length(glm::vec3(seeds.velocities[2])) == 0);
}

// The flow is linear in x and y and rotates with its plane. Bilinear interpolation reproduces such a flow
// exactly.
TEST_CASE("fluid wind: a linear flow is sampled exactly on a skewed plane") {
  sim::FluidPlane plane;
  plane.position = {0.3F, -0.2F, 0.5F};
  plane.rotation = {-90, 0, 0};  // The plane is seen from above: right is x, down is z.
  plane.cell = 0.5F;
  const glm::ivec2 size(12, 9);
  const auto flow = [](glm::dvec2 p) {
    return glm::dvec2(1 + 0.5 * p.x - 0.25 * p.y, -2 + 0.125 * p.x + 0.75 * p.y);
  };
  const WindTwin wind = windOf(plane, size, flow);
  std::vector<glm::vec3> places;
  for (int i = 0; i < 60; ++i)
    places.emplace_back(0.3 + 5.9 * (i * 0.61803 - std::floor(i * 0.61803) - 0.5), i % 7 - 3.0,
                        0.5 + 4.4 * (i * 0.41421 - std::floor(i * 0.41421) - 0.5));
  ParticlesTwin seeds = seedsIn(wind, places, 1, 0);
  seeds.step(0);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec2 cell((places[i].x - 0.3) / 0.5 + 6, (places[i].z - 0.5) / 0.5 + 4.5);
    const glm::dvec2 w = flow(cell) * 0.5;
    // The velocity is the wind's velocity at the starting point. The tolerance covers the displacement
    // during the step.
    const glm::dvec3 expected(w.x, 0, w.y);
    const double share = 1 - std::exp(-1 / 60.0);
    CAPTURE(i);
    CHECK(glm::length(glm::dvec3(seeds.velocities[i]) - expected * share) <
          2e-3 * share * glm::length(expected) + 1e-6);
  }
}

// A free sheet faces a uniform wind w, so m v' = rho Cd A (w - v)^2 / 2. The solution is w - v = w / (1 + k
// w t) with k = rho Cd A / (2 m).
TEST_CASE("fluid wind: a free sheet is carried along as in the closed form") {
  sim::FluidPlane plane;
  plane.cell = 1;
  sim::ClothParameters p;
  p.size = {6, 6};
  p.rotation = {90, 0, 0};
  p.gravity = glm::vec3(0);
  p.wind = glm::vec3(0);
  p.mass = 0.002F;
  p.stiffness = 20;
  p.damping = 0;
  p.substeps = 40;
  p.air.emplace();
  p.air->gusts = 0;
  p.air->velocity = glm::vec3(0);
  p.air->fluid = "storm";
  p.pins.clear();
  plane.rotation = {0, 90, 0};  // The rotation makes the plane's x axis the scene's -z.
  ClothTwin twin(sim::ClothPlan(p, 1, 1.0 / 60, {}));
  twin.wind = windOf(plane, {200, 60}, [](glm::dvec2) { return glm::dvec2(3, 0); });
  for (int frame = 0; frame < 60; ++frame) twin.step(frame / 60.0);
  glm::dvec3 mean(0);
  for (const glm::vec4& v : twin.velocities) mean += glm::dvec3(v) / 36.0;
  const double k = 0.5 * 1.2 * 0.25 / (36 * 0.002);
  CHECK(std::abs(3 + mean.z - 3 / (1 + 3 * k)) < 0.01);
  CHECK(std::abs(mean.x) + std::abs(mean.y) < 0.02);
}

TEST_CASE("fluid wind: names that are not fluids are reported in one line") {
  const auto mistake = [](const std::string& objects) {
    try {
      static_cast<void>(scene::parseScene(R"({"version": 1, "objects": {)" + objects + "}}", "test.json",
                                          {}, sim::kinds()));
    } catch (const UserError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  const std::string grains =
      R"("dust": {"particles": {"groups": [{}], "method": "none", "wind": {"fluid": "smok"}}})";
  const std::string unknown = mistake(grains + R"(, "smoke": {"fluid": {}})");
  CHECK(unknown.find("no object is named \"smok\"") != std::string::npos);
  CHECK(unknown.find("smoke") != std::string::npos);
  CHECK(mistake(grains).find("nothing in the scene blows; add a fluid") != std::string::npos);
  CHECK(mistake(grains + R"(, "smok": {"cloth": {}})").find("is a cloth, which does not blow") !=
        std::string::npos);
  CHECK(mistake(R"("dust": {"particles": {"groups": [{}], "wind": {}}})").find("whose wind?") !=
        std::string::npos);
  CHECK(mistake(R"("flag": {"cloth": {"air": {"fluid": "sea"}}}, "sea": {"water": {}})")
            .find("is a water, which does not blow") != std::string::npos);
}

// A uniform flow at the fluid's "speed" has the effect of a wind with that strength and direction, except
// for rounding of the probabilities.
TEST_CASE("fluid wind: a wildfire in a uniform flow burns as with an equal constant wind") {
  sim::WildfireParameters given;
  given.size = {90, 90};
  given.patchiness = 0;
  given.stepsPerSecond = 60;
  sim::StrokeParameters light;
  light.from = light.to = {45, 45, 0};
  light.radius = 3;
  given.strokes = {light};
  sim::WildfireParameters blown = given;
  given.windStrength = 1.2F;
  given.windDirection = -30.0F;  // The wind blows to the right and down.
  blown.windStrength = 1.2F;
  blown.windFluid = "storm";
  const auto spreadOf = [](WildfireTwin& twin, bool blows) {
    glm::dvec3 sum(0);
    for (int frame = 0; frame < 40; ++frame) {
      if (blows) twin.blow(frame / 60.0, 50);
      twin.step(frame / 60.0);
    }
    for (int i = 0; i < 8100; ++i)
      if (twin.cells[static_cast<std::size_t>(i)] >= 128)
        sum += glm::dvec3(i % 90 - 44.5, i / 90 - 44.5, 1);
    return glm::dvec3(sum.x / sum.z, sum.y / sum.z, sum.z);
  };
  WildfireTwin first(sim::WildfirePlan(given, "fire", 5, 1.0 / 60));
  WildfireTwin second(sim::WildfirePlan(blown, "fire", 5, 1.0 / 60));
  second.wind = windOf({}, {20, 15}, [](glm::dvec2) { return glm::dvec2(50 * std::cos(0.5235988), 25); });
  const glm::dvec3 a = spreadOf(first, false), b = spreadOf(second, true);
  REQUIRE(a.z > 300);
  CHECK(std::abs(a.z - b.z) < 0.02 * a.z);
  CHECK(std::abs(a.x - b.x) < 0.5);
  CHECK(std::abs(a.y - b.y) < 0.5);
  CHECK(a.x > 5);
  CHECK(b.y > 3);
}
