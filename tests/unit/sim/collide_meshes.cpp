// Tests collisions with rigid meshes by comparison with known results. The CPU twins equal the GPU bit for
// bit.
#include "reference/cloth_twin.hpp"
#include "reference/garment_twin.hpp"
#include "reference/particles_twin.hpp"
#include "unit/help.hpp"
#include "unit/sim/balls_help.hpp"
#include "unit/sim/collide_help.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace balls_solids {

sim::ColliderShape sphereBelow(float radius) {
  sim::ColliderShape sphere;
  sphere.kind = sim::ColliderShape::Kind::sphere;
  sphere.position = glm::vec3(0, -radius, 0);
  sphere.radius = radius;
  sphere.friction = 0.4F;
  return sphere;
}

sim::ParticleParameters falling(int count, float radius) {
  sim::ParticleParameters p = balls::parametersOf(count, 0.3F, 0.4F);
  p.contact->radius = radius;
  p.acceleration = glm::vec3(0, -9.81F, 0);
  p.autoSubsteps = true;
  p.collides = true;
  p.bounce = 0.2F;
  p.margin = radius;
  return p;
}

/// Returns a bucket without a lid as OBJ text: a floor and four walls of the thickness 0.06 m around the
/// space |x|, |z| < `half`, 0 < y < `height`.
std::string bucketObj(double half, double height) {
  constexpr double thick = 0.06;
  const double out = half + thick;
  std::string text;
  const auto add = [&](const glm::dvec3& low, const glm::dvec3& high) {
    const glm::dvec3 middle = 0.5 * (low + high), extent = 0.5 * (high - low);
    const auto vertices = static_cast<int>(std::count(text.begin(), text.end(), 'v'));
    for (int i = 0; i < 8; ++i)
      text += fmt::format("v {} {} {}\n", middle.x + ((i & 1) != 0 ? extent.x : -extent.x),
                          middle.y + ((i & 2) != 0 ? extent.y : -extent.y),
                          middle.z + ((i & 4) != 0 ? extent.z : -extent.z));
    const int quads[6][4] = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5},
                             {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}};
    for (const auto& q : quads)
      text += fmt::format("f {} {} {} {}\n", q[0] + vertices, q[1] + vertices, q[2] + vertices,
                          q[3] + vertices);
  };
  // The walls reach into each other and into the floor, because closed parts must not share an edge.
  constexpr double in = 0.02;
  add({-out - in, -thick, -out - in}, {out + in, 0, out + in});
  add({-out, -in, -out}, {-half, height, out});
  add({half, -in, -out}, {out, height, out});
  add({-half - in, -in - 0.01, -out + 0.01}, {half + in, height - 0.01, -half});
  add({-half - in, -in - 0.01, half}, {half + in, height - 0.01, out - 0.01});
  return text;
}

}  // namespace balls_solids

namespace {

constexpr double meshFrame = 1.0 / 60.0;

struct Grain {
  glm::dvec3 position, velocity;
};

struct GrainSetting {
  float bounce = 1, margin = 0.05F;
  glm::vec3 acceleration{0};
  int substeps = 8;
};

/// Returns particles near the first mesh of a scene.
ParticlesTwin grainsBeside(const std::string& mesh, const std::vector<Grain>& grains,
                           const GrainSetting& setting = {}) {
  sim::ParticleParameters p;
  p.groups.emplace_back().count = static_cast<int>(grains.size());
  p.method = sim::GravityMethod::none;
  p.acceleration = setting.acceleration;
  p.substeps = setting.substeps;
  p.collides = true;
  p.bounce = setting.bounce;
  p.margin = setting.margin;
  ParticlesTwin twin(sim::ParticlePlan(p, 1, meshFrame));
  for (std::size_t i = 0; i < grains.size(); ++i) {
    twin.positions[i] = glm::vec4(glm::vec3(grains[i].position), 1);
    twin.velocities[i] = glm::vec4(glm::vec3(grains[i].velocity), 0);
  }
  twin.meshes.emplace(sim::MeshColliderPlan(test::parsedScene(test::meshObject(mesh)), setting.margin));
  return twin;
}

std::string boxMesh(const test::TemporaryFile& file, const std::string& more = "") {
  return fmt::format(R"("shape": "file", "file": "{}"{})", file.path().string(), more);
}

/// Scene text of a torus below a sheet. The radius of the torus is 0.5 m, and the radius of its tube is
/// 0.15 m. overTorus() returns the clearance above it.
constexpr const char* torusUnderCloth =
    R"("shape": "torus", "radius": 0.5, "tube": 0.15, "resolution": [97, 49], "rotation": [0, 20, 0])";

double overTorus(const glm::vec4& p) {
  const double across = std::sqrt(double{p.x} * p.x + double{p.z} * p.z) - 0.5;
  return std::sqrt(across * across + double{p.y} * p.y) - 0.15;
}

}  // namespace

TEST_CASE("collide: balls bounce off a mesh box like off an analytic box and conserve energy") {
  const test::TemporaryFile file("hand.obj", test::boxObj({0.4, 0.3, 0.5}));
  const glm::dvec3 half(0.4, 0.3, 0.5);
  const double margin = 0.05;
  test::Draws draws;
  std::vector<Grain> grains;
  std::vector<glm::dvec3> expected;
  while (grains.size() < 60) {
    // The particle hits the middle part of a face after 0.1 s.
    const int axis = static_cast<int>(grains.size() % 3);
    const double side = grains.size() % 2 == 0 ? 1 : -1;
    glm::dvec3 target = draws.inBox(half * 0.8);
    target[axis] = side * (half[axis] + margin);
    glm::dvec3 v = draws.inBox(glm::dvec3(1));
    v[axis] = -side * (1.5 + draws() * 0.5);
    grains.push_back({target - v * 0.1, v});
    v[axis] = -v[axis];
    expected.push_back(v);
  }
  auto twin = grainsBeside(boxMesh(file, R"(, "grip": 0)"), grains);
  for (int frame = 0; frame < 15; ++frame) twin.step(frame * meshFrame);
  double energy = 0, before = 0;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    CHECK(glm::length(glm::dvec3(twin.velocities[i]) - expected[i]) < 2e-3);
    const glm::dvec3 place = grains[i].position + grains[i].velocity * 0.1 + expected[i] * 0.15;
    // Bounces take effect at the end of a substep, so a position may be off by the distance moved in a
    // substep.
    CHECK(glm::length(glm::dvec3(twin.positions[i]) - place) < 2 * 2 * meshFrame / 8);
    energy += glm::dot(glm::dvec3(twin.velocities[i]), glm::dvec3(twin.velocities[i]));
    before += glm::dot(grains[i].velocity, grains[i].velocity);
  }
  CHECK(energy == doctest::Approx(before).epsilon(1e-5));
}

TEST_CASE("collide: no particle enters a mesh at any speed") {
  const test::TemporaryFile file("thin.obj", test::boxObj({0.5, 0.02, 0.5}));
  std::vector<Grain> grains;
  test::Draws draws;
  for (int i = 0; i < 50; ++i)
    grains.push_back({{0.4 * draws(), 1, 0.4 * draws()}, {draws(), -40.0 - i, draws()}});
  auto twin = grainsBeside(boxMesh(file), grains, {.bounce = 0.2F, .margin = 0.01F, .substeps = 1});
  for (int frame = 0; frame < 20; ++frame) twin.step(frame * meshFrame);
  for (const glm::vec4& p : twin.positions) CHECK(p.y > 0.029);
  // The plate moves at 40 m/s, more than half a metre per substep.
  auto swept = grainsBeside(
      boxMesh(file, R"(, "position": {"keys": [[0, [0, -1, 0]], [0.05, [0, 1, 0]]], "ease": "linear"})"),
      {{{0.1, 0, 0.2}, {0, 0, 0}}}, {.bounce = 0, .margin = 0.01F, .substeps = 1});
  for (int frame = 0; frame < 3; ++frame) swept.step(frame * meshFrame);
  CHECK(swept.positions[0].y > 1.0);
  CHECK(swept.velocities[0].y == doctest::Approx(40).epsilon(0.01));
}

TEST_CASE("collide: a rotating mesh carries objects on it, held by Coulomb friction") {
  const test::TemporaryFile file("turn.obj", test::boxObj({0.5, 0.1, 0.5}));
  const GrainSetting weight{.bounce = 0, .margin = 0.01F, .acceleration = {0, -9.81F, 0}, .substeps = 8};
  // At 0.4 m from the axis, a rotation of 0.9 rad/s gives a speed of 0.36 m/s and an inward acceleration of
  // 0.324 m/s^2.
  const std::string turning =
      R"(, "rotation": {"keys": [[0, [0, 0, 0]], [4, [0, 206.26, 0]]], "ease": "linear"})";
  auto held = grainsBeside(boxMesh(file, turning + R"(, "friction": 0.5)"),
                           {{{0.4, 0.11, 0}, {0, 0, -0.36}}}, weight);
  auto smooth =
      grainsBeside(boxMesh(file, turning + R"(, "friction": 0)"), {{{0.4, 0.11, 0}, {0, 0, 0}}}, weight);
  for (int frame = 0; frame < 60; ++frame) {
    held.step(frame * meshFrame);
    smooth.step(frame * meshFrame);
  }
  const glm::dvec3 expected(0.4 * std::cos(0.9), 0.11, -0.4 * std::sin(0.9));
  CHECK(glm::length(glm::dvec3(held.positions[0]) - expected) < 3e-3);
  CHECK(glm::length(glm::dvec3(held.velocities[0])) == doctest::Approx(0.36).epsilon(0.03));
  CHECK(glm::length(glm::dvec3(smooth.positions[0]) - glm::dvec3(0.4, 0.11, 0)) < 1e-3);
  // The slopes have 20 and 35 degrees. The friction coefficient is 0.5.
  for (const double degrees : {20.0, 35.0}) {
    CAPTURE(degrees);
    const double angle = degrees * M_PI / 180;
    const glm::dvec3 up(-std::sin(angle), std::cos(angle), 0);
    auto slope =
        grainsBeside(boxMesh(file, fmt::format(R"(, "friction": 0.5, "rotation": [0, 0, {}])", degrees)),
                     {{up * 0.11, {0, 0, 0}}}, weight);
    for (int frame = 0; frame < 30; ++frame) slope.step(frame * meshFrame);
    const double way = glm::length(glm::dvec3(slope.positions[0]) - up * 0.11);
    const double theory = 0.125 * 9.81 * (std::sin(angle) - 0.5 * std::cos(angle));
    if (degrees < 26)
      CHECK(way < 2e-4);
    else
      CHECK(std::abs(way - theory) < 0.03 * theory);
  }
}

TEST_CASE("collide: cloth of any material does not sink into a mesh torus") {
  const auto scene = test::parsedScene(test::meshObject(torusUnderCloth));
  const auto settle = [&](auto twin, double margin) {
    twin.meshes.emplace(sim::MeshColliderPlan(scene, margin));
    double minimum = 1e9;
    int touching = 0;
    for (int frame = 0; frame < 60; ++frame) {
      twin.step(frame * meshFrame);
      touching = 0;
      for (const glm::vec4& p : twin.positions) {
        minimum = std::min(minimum, overTorus(p));
        touching += overTorus(p) < margin + 2e-3 ? 1 : 0;
      }
    }
    CHECK(minimum > margin - 1.5e-3);
    CHECK(touching > 30);
  };
  sim::ClothParameters p;
  p.size = {33, 29};
  p.spacing = 0.05F;
  p.position = glm::vec3(0.03F, 0.2F, 0);
  p.wind = glm::vec3(0);
  p.pins.clear();
  p.mass = 0.0003F;
  p.stiffness = 20;
  p.substeps.reset();
  p.margin = 0.01F;
  SUBCASE("springs") {
    settle(ClothTwin(sim::ClothPlan(p, 5, meshFrame, {})), 0.01);
  }
  SUBCASE("constraints") {
    p.fabric.emplace();
    p.solver = sim::ClothSolver::constraints;
    const double thickness = p.fabric->constants().thickness;
    settle(ClothTwin(sim::ClothPlan(p, 5, meshFrame, {})), 0.01 + 0.5 * thickness);
  }
  SUBCASE("a mesh of fabric") {
    p.mesh.emplace();
    p.fabric.emplace();
    p.mesh->shape = sim::ClothShape::disc;
    p.mesh->radius = 0.8F;
    p.mesh->resolution = {21, 3};
    const double thickness = p.fabric->constants().thickness;
    settle(GarmentTwin(sim::GarmentPlan("disc", p, 5, meshFrame, {})), 0.01 + 0.5 * thickness);
  }
}

// Balls at one position once left it as a column 11 m high, at 12 m/s.
TEST_CASE("balls: balls at one position above a ball or the ground part sideways, without a throw") {
  for (const bool sphere : {false, true}) {
    CAPTURE(sphere);
    const auto p = balls_solids::falling(60, 0.05F);
    const auto solids = sphere ? std::vector{balls_solids::sphereBelow(0.3F)} : balls::box(0, 0.4);
    ParticlesTwin twin(sim::ParticlePlan(p, 1, balls::frame, 1 << 20, solids));
    for (glm::vec4& place : twin.positions) place = glm::vec4(0, 0.06F, 0, 1);
    for (glm::vec4& velocity : twin.velocities) velocity = glm::vec4(0);
    float fastest = 0, highest = 0, nearest = 1;
    for (int frame = 0; frame < 15; ++frame) {
      twin.step(frame * balls::frame);
      for (std::size_t i = 0; i < twin.positions.size(); ++i) {
        const glm::vec3 place(twin.positions[i]);
        fastest = std::max(fastest, glm::length(glm::vec3(twin.velocities[i])));
        highest = std::max(highest, place.y);
        nearest = std::min(nearest, sphere ? glm::distance(place, glm::vec3(0, -0.3F, 0)) - 0.3F : place.y);
      }
    }
    CHECK(nearest > 0.0499F);
    CHECK(highest < 0.5F);
    CHECK(fastest < 3);
    CHECK(balls::deepest(twin) < 0.02);
  }
}

TEST_CASE("balls: balls that start at one position are moved apart in all directions") {
  sim::ParticleParameters p = balls_solids::falling(40, 0.05F);
  p.groups[0].shape = sim::ParticleGroup::Shape::ball;
  p.groups[0].radius = 1e-7F;
  const auto cloud = sim::ParticlePlan(p, 1, balls::frame).firstCloud();
  for (const int axis : {0, 1, 2}) {
    float low = 0, high = 0;
    for (const glm::vec4& place : cloud.positions) {
      low = std::min(low, place[axis]);
      high = std::max(high, place[axis]);
    }
    CHECK(high - low > 0.2F);
    CHECK(high - low < 0.8F);
  }
}

TEST_CASE("balls: of 500 balls poured into a bucket, none passes its walls or its floor") {
  constexpr float radius = 0.04F, half = 0.3F;
  constexpr int count = 500;
  const test::TemporaryFile file("bucket.obj", balls_solids::bucketObj(half, 1.1));
  const auto scene = test::parsedScene(
      test::meshObject(fmt::format(R"("shape": "file", "file": "{}")", file.path().string())));
  auto p = balls_solids::falling(count, radius);
  p.autoSubsteps = false;
  p.substeps = 8;
  ParticlesTwin twin(sim::ParticlePlan(p, 1, balls::frame));
  twin.meshes.emplace(sim::MeshColliderPlan(scene, 0.08));
  for (int i = 0; i < count; ++i) {
    const auto s = static_cast<std::size_t>(i);
    const glm::vec3 shift = shader::signedUnits(shader::hash3({static_cast<unsigned>(i), 4, 2})) * 0.008F;
    twin.positions[s] = glm::vec4(glm::vec3(i % 6 - 2.5F, i / 36, i / 6 % 6 - 2.5F) * 0.082F + shift, 1);
    twin.positions[s].y += 0.15F;
    twin.velocities[s] = glm::vec4(0, -3, 0, 0);
  }
  float nearest = 1;
  for (int frame = 0; frame < 200; ++frame) {
    twin.step(frame * balls::frame);
    for (const glm::vec4& place : twin.positions)
      nearest = std::min({nearest, place.y, half - std::abs(place.x), half - std::abs(place.z)});
  }
  CHECK(nearest > 0.9F * radius);
  CHECK(balls::deepest(twin) < 0.5);
  for (const glm::vec4& place : twin.positions) CHECK(place.y < 1.1F);
}
