// Tests collisions between floats by comparison with closed forms: contact shapes, bouncing, friction and
// penetration.
#include "reference/water_twin.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

constexpr double meetFrame = 1.0 / 30;

double along(const glm::dvec3& a, const glm::dvec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
glm::dvec3 crossOf(const glm::dvec3& a, const glm::dvec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double longOf(const glm::dvec3& v) {
  return std::sqrt(along(v, v));
}

/// Returns the distance to a box around the origin. It is negative inside.
double boxDistance(const glm::dvec3& p, const glm::dvec3& half) {
  const glm::dvec3 q = glm::abs(p) - half;
  return longOf(glm::max(q, glm::dvec3(0))) + std::min(std::max({q.x, q.y, q.z}), 0.0);
}

sim::WaterFloat meetBox(glm::vec3 size, glm::vec3 at) {
  sim::WaterFloat body;
  body.shape = sim::WaterFloatShape::box;
  body.size = size;
  body.position = at;
  body.density = 400;
  body.drag = body.resistance = 0;
  return body;
}

sim::WaterFloat meetBall(float radius, glm::vec3 at, glm::vec3 velocity) {
  sim::WaterFloat body;
  body.radius = radius;
  body.position = at;
  body.velocity = velocity;
  return body;
}

WaterTwin meetTwin(std::vector<sim::WaterFloat> floats, int cells = 16, bool torus = false) {
  sim::WaterParameters p;
  p.size = {cells, cells};
  p.cell = 0.5F;
  if (torus) p.sides.fill(sim::WaterBorder::periodic);
  p.bed = -2;
  p.greatestSpeed = 3;
  p.floats = std::move(floats);
  return WaterTwin(sim::WaterPlan(p, "tank", 1, meetFrame));
}

glm::dvec3 meetSpeed(const WaterTwin& twin, std::size_t body) {
  return glm::dvec3(twin.floats[5 * body + 2]);
}
double meetMass(const WaterTwin& twin, std::size_t body) {
  return twin.plan().floats().hulls()[body].mass;
}

/// Returns the linear and angular momentum of all floats about the origin.
std::array<glm::dvec3, 2> momenta(const WaterTwin& twin) {
  std::array<glm::dvec3, 2> sum{glm::dvec3(0), glm::dvec3(0)};
  for (std::size_t i = 0; i < twin.floats.size() / 4; ++i) {
    const glm::dvec3 p = meetMass(twin, i) * meetSpeed(twin, i);
    sum[0] += p;
    sum[1] += crossOf(glm::dvec3(twin.floats[5 * i]), p) + glm::dvec3(twin.floats[5 * i + 3]);
  }
  return sum;
}

glm::dvec3 meetTurned(const glm::dvec4& q, const glm::dvec3& v) {
  const glm::dvec3 u(q.x, q.y, q.z);
  return v + 2.0 * crossOf(u, crossOf(u, v) + q.w * v);
}

/// Returns the maximum depth (m) of a vertex or an edge midpoint of one body's mesh inside the other body's
/// mesh. Tests all faces.
double overlap(const WaterTwin& twin, std::size_t one, std::size_t other, const sim::ClosedMesh& mesh) {
  const sim::Hull& hull = twin.plan().floats().hulls()[other];
  double deepest = 0;
  for (const glm::vec3& corner : twin.plan().floats().hulls()[one].corners) {
    const glm::dvec3 world = glm::dvec3(twin.floats[5 * one]) +
                             meetTurned(glm::dvec4(twin.floats[5 * one + 1]), glm::dvec3(corner));
    glm::dvec4 inverse(twin.floats[5 * other + 1]);
    inverse.w = -inverse.w;
    const glm::dvec3 p = meetTurned(inverse, world - glm::dvec3(twin.floats[5 * other])) + hull.middle;
    if (p.x < mesh.low.x || p.y < mesh.low.y || p.z < mesh.low.z || p.x > mesh.high.x ||
        p.y > mesh.high.y || p.z > mesh.high.z)
      continue;
    double nearest = 1e9, sign = 1;
    for (const sim::ClosedMesh::Face& face : mesh.faces) {
      const sim::NearestOnFace found = sim::nearestOnFace(face, p);
      const double away = longOf(p - found.place);
      if (away >= nearest) continue;
      nearest = away;
      sign = along(p - found.place, found.normal) < 0 ? -1 : 1;
    }
    deepest = std::max(deepest, -sign * nearest);
  }
  return deepest;
}

}  // namespace

TEST_CASE("water floats: contact with a box uses its surface") {
  const sim::Hull hull(meetBox({0.6F, 0.4F, 1.5F}, {}), "box");
  const sim::FloatShape& shape = hull.touched;
  CHECK(shape.radius == 0);
  REQUIRE(shape.counts.x * shape.counts.y * shape.counts.z == static_cast<int>(shape.nodes.size()));
  double worst = 0;
  std::size_t i = 0;
  for (int z = 0; z < shape.counts.z; ++z)
    for (int y = 0; y < shape.counts.y; ++y)
      for (int x = 0; x < shape.counts.x; ++x, ++i) {
        const glm::dvec3 p = shape.low + shape.step * glm::dvec3(x, y, z) + hull.middle;
        worst = std::max(worst, std::abs(shape.nodes[i].w - boxDistance(p, {0.3, 0.2, 0.75})));
        CHECK(longOf(glm::dvec3(shape.nodes[i])) == doctest::Approx(1).epsilon(1e-5));
      }
  CHECK(worst < 1e-5);
  CHECK(shape.probes.size() > 100);
  int corners = 0;
  for (const glm::vec4& probe : shape.probes) {
    CHECK(std::abs(boxDistance(glm::dvec3(probe) + hull.middle, {0.3, 0.2, 0.75})) < 1e-5);
    const glm::dvec3 off = glm::abs(glm::dvec3(probe) + hull.middle) - glm::dvec3(0.3, 0.2, 0.75);
    corners += longOf(off) < 1e-5 ? 1 : 0;
  }
  CHECK(corners == 8);
  CHECK(sim::Hull(meetBall(0.3F, {}, {}), "ball").touched.radius == doctest::Approx(0.3));
}

TEST_CASE("water floats: two floats that collide in the air do not bounce and conserve momentum") {
  // The bodies collide along the line between their centres. Afterwards both move at the mean speed.
  auto box = meetBox({0.8F, 0.8F, 0.8F}, {-0.6F, 30, 0});
  box.velocity = {1, 0, 0};
  auto heavy = meetBox({0.8F, 0.8F, 0.8F}, {0.6F, 30, 0});
  heavy.velocity = {-1, 0, 0};
  heavy.density = 1200;
  WaterTwin flat = meetTwin({box, heavy});
  for (int i = 0; i < 15; ++i) flat.step(i * meetFrame);
  CHECK(std::abs(meetSpeed(flat, 0).x - meetSpeed(flat, 1).x) < 0.1);
  CHECK((meetSpeed(flat, 0).x + 3 * meetSpeed(flat, 1).x) / 4 == doctest::Approx(-0.5).epsilon(1e-4));
  CHECK(longOf(glm::dvec3(flat.floats[3])) < 0.02 * meetMass(flat, 0));
  CHECK(flat.floats[5].x - flat.floats[0].x > 0.76);
  // The collision is off-centre and with rotation. It must conserve linear and angular momentum.
  box.rotation = {20, 30, 10};
  box.spin = {90, 40, -100};
  heavy.position += glm::vec3(0, 0.3F, 0.35F);
  heavy.rotation = {-15, 0, 50};
  WaterTwin askew = meetTwin({box, heavy, meetBall(0.3F, {0, 30.9F, 0.1F}, {0.1F, -1, 0})});
  const auto before = momenta(askew);
  const double all = meetMass(askew, 0) + meetMass(askew, 1) + meetMass(askew, 2);
  const glm::dvec3 middle(askew.floats[0]);
  const double seconds = 20 * meetFrame;
  for (int i = 0; i < 20; ++i) askew.step(i * meetFrame);
  const auto after = momenta(askew);
  const glm::dvec3 fallen(0, -9.81 * seconds * all, 0);
  MESSAGE("momentum off by ", longOf(after[0] - before[0] - fallen), " of ", meetMass(askew, 0), " kg m/s");
  CHECK(longOf(after[0] - before[0] - fallen) < 1e-3 * meetMass(askew, 0));
  CHECK(longOf(glm::dvec3(askew.floats[3]) - glm::dvec3(0)) > 1);
  // Gravity does not change the angular momentum about the vertical.
  CHECK(std::abs(after[1].y - before[1].y) < 1e-3 * longOf(before[1]));
  CHECK(std::abs(middle.x - askew.floats[0].x) < 2);
}

TEST_CASE("water floats: sliding floats have Coulomb friction, and slower contacts stick") {
  // The spheres are equal. The tangential impulse must be mu times the normal impulse. With strong
  // friction, it must instead change the tangential speed by 2/7, so that the contact does not slip.
  for (const float friction : {0.1F, 5.0F}) {
    CAPTURE(friction);
    auto left = meetBall(0.4F, {-0.5F, 30, -0.06F}, {1, 0, 0.6F});
    auto right = meetBall(0.4F, {0.5F, 30, 0.06F}, {-1, 0, -0.6F});
    left.friction = right.friction = friction;
    WaterTwin twin = meetTwin({left, right});
    for (int i = 0; i < 4; ++i) twin.step(i * meetFrame);
    const glm::dvec3 after = meetSpeed(twin, 0);
    const glm::dvec3 n = glm::dvec3(twin.floats[4]) - glm::dvec3(twin.floats[0]);
    CHECK(std::abs(along(after - meetSpeed(twin, 1), n / longOf(n))) < 0.1);
    const double across = (0.6 - after.z) / (1 - after.x);
    CHECK(across == doctest::Approx(friction < 1 ? 0.1 : 0.6 * 2 / 7).epsilon(0.2));
    const double turning = twin.floats[3].y / (0.4 * meetMass(twin, 0) * 0.16);
    const double slip = after.z - meetSpeed(twin, 1).z - turning * 0.8;
    CHECK(turning > 0.1);
    if (friction > 1) CHECK(std::abs(slip) < 0.1);
  }
}

TEST_CASE("water floats: driven boats do not pass through each other") {
  const std::string file = __FILE__;
  const auto root = std::filesystem::path(file).parent_path().parent_path().parent_path().parent_path();
  sim::WaterFloat boat;
  boat.shape = sim::WaterFloatShape::file;
  boat.file = root / "assets/meshes/boat.obj";
  if (!std::filesystem::exists(boat.file)) return;
  boat.mass = 3200;
  boat.ballast = {0, -0.35F, 0};
  boat.keel = 5;
  boat.thrust = 3000.0F;
  boat.position = {-3.3F, 0.1F, 0.4F};
  boat.rotation = {0, 80, 0};
  boat.velocity = {1.5F, 0, 0};
  sim::WaterFloat other = boat;
  other.position = {3.3F, 0.1F, -0.3F};
  other.rotation = {0, -75, 0};
  other.velocity = {-1.5F, 0, 0};
  WaterTwin twin = meetTwin({boat, other}, 40, true);
  const sim::ClosedMesh mesh("boat", sim::loadMesh(boat.file), 1);
  const auto all = [&] {
    glm::dvec2 sum(0);
    for (std::size_t i = 0; i < 2; ++i)
      sum += meetMass(twin, i) * glm::dvec2(meetSpeed(twin, i).x, meetSpeed(twin, i).z);
    for (const glm::vec4& c : twin.cells) sum += 250.0 * glm::dvec2(c.y, c.z);
    return sum;
  };
  const glm::dvec2 before = all();
  double deepest = 0, nearest = 100, off = 0;
  for (int i = 0; i < 60; ++i) {
    twin.step(i * meetFrame);
    deepest = std::max({deepest, overlap(twin, 0, 1, mesh), overlap(twin, 1, 0, mesh)});
    nearest = std::min(nearest, longOf(glm::dvec3(twin.floats[4]) - glm::dvec3(twin.floats[0])));
    off = std::max({off, std::abs(all().x - before.x), std::abs(all().y - before.y)});
  }
  MESSAGE("deepest ", deepest, " m, nearest ", nearest, " m, momentum off by ", off, " kg m/s");
  CHECK(nearest < 5.2);  // The floats meet bow to bow or side to side.
  CHECK(nearest > 1.2);
  CHECK(deepest < 0.1);
  CHECK(off < 1e-4 * 3200 * 1.5);
}
