#include "measured.hpp"
#include "reference/water_twin.hpp"
#include "sim/water/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

constexpr double floatFrame = 1.0 / 30;

/// Returns a pool with walls, 3 m deep, that contains one body.
sim::WaterParameters poolWith(const sim::WaterFloat& body, int cells = 40, float cell = 0.1F) {
  sim::WaterParameters p;
  p.size = {cells, cells};
  p.cell = cell;
  p.bed = -3;
  p.greatestSpeed = 2;
  p.floats = {body};
  return p;
}

WaterTwin twinOf(const sim::WaterParameters& p) {
  return WaterTwin(sim::WaterPlan(p, "pool", 1, floatFrame));
}

double floatOf(const WaterTwin& twin, const char* name) {
  return named(sim::WaterParameters(), sim::measureWater(twin.plan(), twin.cells, twin.floats), name);
}

void run(WaterTwin& twin, double seconds, double from = 0) {
  for (int i = 0; i < seconds / floatFrame; ++i) twin.step(from + i * floatFrame);
}

sim::WaterFloat boxOf(const glm::vec3& size, float density) {
  sim::WaterFloat body;
  body.shape = sim::WaterFloatShape::box;
  body.size = size;
  body.density = density;
  body.resistance = 1;
  body.drag = 1;
  return body;
}

/// Returns the draft d of a sphere with radius R and the fraction `under` of its volume submerged, from the
/// submerged volume pi d^2 (3 R - d) / 3.
double ballDraft(double radius, double under) {
  double low = 0;
  double high = 2 * radius;
  for (int i = 0; i < 100; ++i) {
    const double d = 0.5 * (low + high);
    (d * d * (3 * radius - d) < 4 * under * radius * radius * radius ? low : high) = d;
  }
  return low;
}

}  // namespace

TEST_CASE("water floats: a hull has the volume, centre and inertia of its shape") {
  const sim::Hull box(boxOf({0.6F, 0.3F, 1.5F}, 400), "box");
  CHECK(box.volume == doctest::Approx(0.27).epsilon(1e-6));
  CHECK(box.outline == doctest::Approx(0.9).epsilon(1e-3));
  CHECK(box.mass == doctest::Approx(108).epsilon(1e-5));
  CHECK(box.inertia[0] == doctest::Approx(9 * (0.09 + 2.25)).epsilon(1e-3));
  CHECK(box.inertia[1] == doctest::Approx(9 * (0.36 + 2.25)).epsilon(1e-3));
  CHECK(box.inertia[2] == doctest::Approx(9 * (0.36 + 0.09)).epsilon(1e-3));
  CHECK(std::abs(box.inertia[3]) < 1e-3);
  CHECK(box.inverseInertia()[1] * box.inertia[1] == doctest::Approx(1).epsilon(1e-5));
  sim::WaterFloat ball;
  ball.radius = 0.5F;
  const sim::Hull round(ball, "ball");
  CHECK(round.volume == doctest::Approx(0.523599).epsilon(1e-5));
  CHECK(round.inertia[2] == doctest::Approx(0.4 * round.mass * 0.25).epsilon(5e-3));
  CHECK(round.points.size() > 300);
}

TEST_CASE("water floats: drafts at rest satisfy Archimedes' principle") {
  for (const float density : {300.0F, 700.0F}) {
    auto body = boxOf({0.8F, 0.5F, 1}, density);
    body.position.y = 0.3F - 0.5F * density / 1000;  // The body starts 5 cm above its equilibrium.
    auto p = poolWith(body, 24, 0.2F);
    p.drag = 0.5F;
    WaterTwin twin = twinOf(p);
    run(twin, 12);
    CHECK(floatOf(twin, "draft") == doctest::Approx(0.5 * density / 1000).epsilon(0.01));
    CHECK(floatOf(twin, "floatSpeed") < 0.1);
    CHECK(floatOf(twin, "leastUpright") > 0.9999);
  }
  sim::WaterFloat ball;
  ball.radius = 0.4F;
  ball.density = 250;
  ball.drag = 1;
  ball.position.y = 0.2F;
  auto p = poolWith(ball, 24, 0.2F);
  p.drag = 0.5F;
  WaterTwin twin = twinOf(p);
  run(twin, 12);
  CHECK(floatOf(twin, "draft") == doctest::Approx(ballDraft(0.4, 0.25)).epsilon(0.01));
  CHECK(floatOf(twin, "displaced") * 1000 ==
        doctest::Approx(twin.plan().floats().hulls()[0].mass).epsilon(0.02));
}

TEST_CASE("water floats: a box and the water in a closed basin only lose energy") {
  // In a closed basin, a wrong lag of the reference level (glsl/water/float_model.glsl) would feed energy
  // to the waves.
  for (const float density : {250.0F, 500.0F}) {
    auto body = boxOf({1, 0.4F, 1}, density);
    body.drag = 0;
    body.resistance = 0;
    body.position.y = 0.2F - 0.4F * density / 1000 + 0.03F;  // The body starts 3 cm above its equilibrium.
    WaterTwin twin = twinOf(poolWith(body, 20, 0.3F));
    const double mass = twin.plan().floats().hulls()[0].mass;
    const double given =
        0.5 * 1000 * 9.81 * 0.03 * 0.03;  // potential energy (J) at the start, rho g A d^2 / 2
    const auto moving = [&] {
      const double speed = floatOf(twin, "floatSpeed");
      return floatOf(twin, "kineticEnergy") + 0.5 * mass * speed * speed;
    };
    double early = 0, late = 0;
    for (int i = 0; i < 900; ++i) {
      twin.step(i * floatFrame);
      double& maximum = i < 300 ? early : late;
      if (i < 300 || i >= 600) maximum = std::max(maximum, moving());
    }
    MESSAGE("given ", given, " J, moving with ", early, " J in 10 s, ", late, " J after 20 s");
    CHECK(early < given);
    CHECK(late < 0.7 * early);
    CHECK(floatOf(twin, "draft") == doctest::Approx(0.4 * density / 1000).epsilon(0.02));
  }
}

TEST_CASE("water floats: a box heaves with the period given by its draft") {
  // The period is T = 2 pi sqrt(M / (rho g A)) = 2 pi sqrt(draft / g), without added mass. The water's
  // added mass comes from flow below the body, which shallow water does not have.
  auto body = boxOf({0.6F, 0.5F, 0.6F}, 400);
  body.drag = 0;
  body.resistance = 0;
  body.position.y = 0.12F;  // The equilibrium is at 0.05 m. The body starts 0.07 m higher.
  auto p = poolWith(body, 60, 0.1F);
  p.bed = -8;
  p.sides.fill(sim::WaterBorder::open);
  WaterTwin twin = twinOf(p);
  std::vector<double> crossings;
  double before = 1;
  for (int i = 0; i < 90 && crossings.size() < 4; ++i) {
    const double y = static_cast<double>(twin.floats[0].y) - 0.05;
    if (i > 0 && before * y < 0) crossings.push_back(i - y / (y - before));
    before = y;
    twin.step(i * floatFrame);
  }
  REQUIRE(crossings.size() == 4);
  const double period = (crossings[3] - crossings[1]) * floatFrame;
  MESSAGE("heave: period ", period, " s, ", 2 * 3.14159265 * std::sqrt(0.2 / 9.81), " s by its draft");
  CHECK(period == doctest::Approx(2 * 3.14159265 * std::sqrt(0.2 / 9.81)).epsilon(0.1));
}

TEST_CASE("water floats: a wide box returns upright, a tall box capsizes") {
  // The metacentric height is GM = I / V minus the distance from the centre of buoyancy to the centre of
  // mass, which is b^2 / (12 d) - (H - d) / 2 with breadth b, draft d and height H.
  for (const bool wide : {true, false}) {
    auto body = wide ? boxOf({1.2F, 0.5F, 1}, 500) : boxOf({0.5F, 1.2F, 1}, 500);
    body.rotation = {0, 0, 12};
    WaterTwin twin = twinOf(poolWith(body, 24, 0.2F));
    run(twin, 8);
    const double upright = floatOf(twin, "leastUpright");
    MESSAGE((wide ? "wide" : "tall"), ": cosine ", upright);
    if (wide)
      CHECK(upright > 0.999);
    else
      CHECK(std::abs(upright) < 0.5);
  }
}

TEST_CASE("water floats: a ball that plunges in and out conserves the water's volume and makes rings") {
  sim::WaterFloat ball;
  ball.radius = 0.4F;
  ball.density = 200;
  ball.position = {0.1F, 1.5F, -0.2F};
  WaterTwin twin = twinOf(poolWith(ball));
  const double before = floatOf(twin, "volume");
  double highest = 0;
  double maximum = 0;
  for (int i = 0; i < 90; ++i) {
    twin.step(i * floatFrame);
    double sum = 0;
    double displaced = 0;
    for (std::size_t k = 0; k < twin.cells.size(); ++k) {
      sum += (static_cast<double>(twin.cells[k].x) - twin.cells[k].w) * 0.01;
      displaced += twin.displaced[k].w * static_cast<double>(twin.plan().floats().step().depthUnit) * 0.01;
    }
    maximum = std::max(maximum, displaced);
    CHECK(sum - displaced == doctest::Approx(before).epsilon(1e-6));
    highest = std::max<double>(highest, twin.cells[40 * 20 + 36].x);
  }
  CHECK(maximum > 0.1);    // This is the displaced volume in m^3. The float's volume is 0.268 m^3.
  CHECK(highest > 0.005);  // The height of the wave is measured 1.6 m from the point of impact.
}

TEST_CASE("water floats: momentum lost to drag goes to the water") {
  auto body = boxOf({0.6F, 0.4F, 0.9F}, 500);
  body.velocity = {1.5F, 0, 0.5F};
  auto p = poolWith(body, 32, 0.25F);
  p.sides.fill(sim::WaterBorder::periodic);
  WaterTwin twin = twinOf(p);
  const double mass = twin.plan().floats().hulls()[0].mass;
  const auto momentum = [&] {
    glm::dvec2 sum(mass * twin.floats[2].x, mass * twin.floats[2].z);
    for (const glm::vec4& c : twin.cells) sum += 1000.0 * 0.0625 * glm::dvec2(c.y, c.z);
    return sum;
  };
  const glm::dvec2 before = momentum();
  run(twin, 3);
  CHECK(twin.floats[2].x < 0.8F);
  CHECK(momentum().x == doctest::Approx(before.x).epsilon(5e-3));
  CHECK(momentum().y == doctest::Approx(before.y).epsilon(5e-3));
}

TEST_CASE("water floats: a body slides down sloping water as fast as the water") {
  // The gradient of the pressure over the body's draft accelerates the body by dv/dt = -g w_x, where w_x is
  // the slope of the water. The test also includes a free fall.
  auto body = boxOf({0.8F, 0.5F, 1}, 500);
  body.drag = 0;
  body.resistance = 0;
  auto p = poolWith(body, 40, 0.2F);
  p.floats.push_back(body);
  p.floats[1].position = {2, 3, 2};
  WaterTwin twin = twinOf(p);
  for (std::size_t i = 0; i < twin.cells.size(); ++i)
    twin.cells[i].x = 0.02F * 0.2F * (static_cast<float>(i % 40) - 19.5F);
  twin.step(0);
  twin.step(floatFrame);
  CHECK(static_cast<double>(twin.floats[2].x) ==
        doctest::Approx(-9.81 * 0.02 * 2 * floatFrame).epsilon(0.03));
  CHECK(std::abs(twin.floats[2].z) < 1e-5F);
  CHECK(static_cast<double>(twin.floats[7].y) == doctest::Approx(-9.81 * 2 * floatFrame).epsilon(1e-4));
}

TEST_CASE("water floats: bodies rest on the ground, keep apart and follow a tow") {
  // This sphere lands on a dry beach.
  sim::WaterFloat ball;
  ball.radius = 0.3F;
  ball.position = {0, 1.5F, 0};
  auto p = poolWith(ball, 24, 0.2F);
  p.bed = 1;
  WaterTwin ashore = twinOf(p);
  run(ashore, 4);
  CHECK(std::abs(ashore.floats[0].y - 1.3) < 0.06);
  CHECK(floatOf(ashore, "floatSpeed") < 0.1);

  p = poolWith(ball, 24, 0.2F);
  p.floats[0].position = {-0.8F, 0, 0};
  p.floats[0].velocity = {1.5F, 0, 0};
  p.floats.push_back(p.floats[0]);
  p.floats[1].position = {0.8F, 0, 0};
  p.floats[1].velocity = {-1.5F, 0, 0};
  WaterTwin two = twinOf(p);
  double nearest = 10;
  for (int i = 0; i < 60; ++i) {
    two.step(i * floatFrame);
    nearest = std::min<double>(nearest, two.floats[5].x - two.floats[0].x);
  }
  CHECK(nearest > 0.5);
  CHECK(nearest < 0.62);

  auto boat = boxOf({0.5F, 0.3F, 1}, 400);
  boat.tow.emplace().position =
      scene::Animated<glm::vec3>({{0, {-1.5F, 0, 0}}, {4, {1.5F, 0, 0}}}, scene::Ease::linear);
  boat.position = {-1.5F, 0, 0};
  boat.tow->pull = 5;
  WaterTwin towed = twinOf(poolWith(boat, 30, 0.2F));
  run(towed, 3);
  CHECK(std::abs(towed.floats[0].x - 0.75) < 0.35);
  // The body's z axis points along x, which is a quarter turn about y.
  CHECK(std::abs(towed.floats[1].y) == doctest::Approx(0.7071).epsilon(0.03));
}

TEST_CASE("water floats: a box standing on an island's slope makes no jets in shallow water below it") {
  auto box = boxOf({1, 0.4F, 2}, 500);
  box.position = {-0.4F, 0, 0};
  auto p = poolWith(box, 61, 0.07F);
  p.bed = -1;
  p.hills.resize(1);
  p.hills[0].center = {-0.9F, 0, 0.1F};
  p.hills[0].radii = {1.4F, 0, 1.2F};
  p.hills[0].height = 1.15F;
  WaterTwin twin = twinOf(p);
  double fastest = 0;
  for (int i = 0; i < 30; ++i) {
    twin.step(i * floatFrame);
    fastest = std::max(fastest, floatOf(twin, "courant"));
  }
  CHECK(std::all_of(twin.cells.begin(), twin.cells.end(), [](const glm::vec4& cell) {
    return std::isfinite(cell.x) && std::isfinite(cell.y) && std::isfinite(cell.z);
  }));
  CHECK(fastest < 0.5);
}
