// Tests the deformation model on the CPU. Compares heights and normals with their formulas, and checks the
// faces around vertices and a clear one-line message for each error.
#include "base/error.hpp"
#include "scene/load.hpp"
#include "sim/mesh/deform_cpu.hpp"
#include "sim/mesh/shapes.hpp"
#include "sim/world/list.hpp"
#include "unit/help.hpp"

#include <cmath>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

sim::MeshParameters planeOf(float size, glm::ivec2 resolution) {
  sim::MeshParameters p;
  p.size = glm::vec3(size, 0, size);
  p.resolution = resolution;
  p.deform.list.resize(1);
  return p;
}

struct Deformed {
  Deformed(const sim::MeshParameters& p, double time, const std::vector<sim::ColliderShape>& colliders = {},
           bool press = false)
      : mesh(p.make(1)), plan("m", p, mesh, colliders), rest("m", mesh), cpu(rest, plan.trailCells()) {
    if (press) cpu.press(plan.at(time), sim::Threads::all);
    cpu.displace(plan.at(time), sim::Threads::all);
    cpu.gatherNormals(sim::Threads::all);
  }
  sim::Mesh mesh;
  sim::DeformPlan plan;
  sim::RestMesh rest;
  sim::DeformCpu cpu;
};

std::string deformFailure(const std::string& mesh) {
  try {
    const scene::Scene scene = scene::parseScene(
        R"({"version": 1, "objects": {"m": {"mesh": {)" + mesh + "}}}}", "test.json", {}, sim::kinds());
    const auto& p = dynamic_cast<const sim::MeshParameters&>(*scene.objects.at(0).parameters);
    const Deformed d(p, 0);
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::usage);
    return error.what();
  }
  return "no failure";
}

}  // namespace

TEST_CASE("a ripple's heights and normals equal its formula, also after a year") {
  auto p = planeOf(8, {201, 161});
  p.deform.list[0].ripple.on = true;
  for (const double time : {0.0, 0.7, 31'557'600.25}) {
    const Deformed d(p, time);
    double worstHeight = 0;
    double worstNormal = 0;
    for (std::size_t i = 0; i < d.mesh.positions.size(); ++i) {
      const glm::dvec3 rest(d.mesh.positions[i]);
      const double r = std::hypot(rest.x, rest.z);
      const double phase = time * 2.0 + 6.0 - r;
      worstHeight = std::max(worstHeight, std::abs(0.25 * std::sin(phase) - d.cpu.positions()[i].y));
      // For y = A sin(.. - r), the gradient is -A cos(.. - r) (x, z) / r. It is tested only away from the
      // centre and the border.
      if (r < 0.5 || std::max(std::abs(rest.x), std::abs(rest.z)) > 3.9) continue;
      const double slope = -0.25 * std::cos(phase) / r;
      const glm::dvec3 normal = glm::normalize(glm::dvec3(-slope * rest.x, 1, -slope * rest.z));
      worstNormal = std::max(worstNormal, glm::length(normal - glm::dvec3(d.cpu.normals()[i])));
    }
    CHECK(worstHeight < 2e-6);
    CHECK(worstNormal < 2e-3);
  }
}

TEST_CASE("Gerstner waves on deep water: w^2 = g k holds, and crests are as high as the amplitude") {
  auto p = planeOf(10, {401, 3});
  p.deform.list[0].waves.resize(1);
  p.deform.list[0].waves[0].length = 2.5F;
  p.deform.list[0].waves[0].amplitude = 0.1F;
  const Deformed start(p, 0);
  const double period = 2 * 3.14159265358979 / std::sqrt(9.81 * 2 * 3.14159265358979 / 2.5);
  const Deformed later(p, period);
  double highest = 0;
  double pixelDifference = 0;
  for (std::size_t i = 0; i < start.mesh.positions.size(); ++i) {
    highest = std::max(highest, double{start.cpu.positions()[i].y});
    pixelDifference =
        std::max(pixelDifference, double{glm::length(start.cpu.positions()[i] - later.cpu.positions()[i])});
  }
  CHECK(highest == doctest::Approx(0.1).epsilon(0.001));
  CHECK(pixelDifference < 1e-5);
}

TEST_CASE("sway fixes the roots, bends the tips and nearly keeps the length") {
  sim::MeshParameters p;
  p.shape = sim::MeshShape::grass;
  p.blades = 301;
  p.deform.list.resize(1);
  p.deform.list[0].sway.on = true;
  p.deform.list[0].sway.height = 0.5F;
  const Deformed d(p, 1.3);
  double leaned = 0;
  for (std::size_t i = 0; i < d.mesh.positions.size(); i += 10) {
    CHECK(glm::vec3(d.cpu.positions()[i]) == d.mesh.positions[i]);
    const glm::vec3 tip = d.mesh.positions[i + 8] - d.mesh.positions[i];
    const glm::vec3 bent = glm::vec3(d.cpu.positions()[i + 8]) - d.mesh.positions[i];
    leaned += glm::length(bent - tip);
    CHECK(bent.y <= tip.y);
  }
  CHECK(leaned / 301 > 0.02);
}

TEST_CASE("a sphere leaves a footprint of its depth with a rim, and nothing elsewhere") {
  auto p = planeOf(4, {161, 141});
  p.deform.list[0].footprints.on = true;
  p.deform.list[0].footprints.depth = 1;
  sim::ColliderShape ball;
  ball.radius = 0.5F;
  ball.position = glm::vec3(0, 0.3F, 0);
  const Deformed d(p, 0, {ball}, true);
  float lowest = 0;
  float highest = 0;
  for (const glm::vec4& v : d.cpu.positions()) {
    lowest = std::min(lowest, v.y);
    highest = std::max(highest, v.y);
    if (std::hypot(v.x, v.z) > 1.0F) CHECK(std::abs(v.y) < 1e-6F);
  }
  CHECK(lowest == doctest::Approx(-0.2).epsilon(0.01));
  CHECK(highest > 0.01F);
  CHECK(highest < 0.05F);
}

TEST_CASE("push leaves no vertex inside a sphere") {
  auto p = planeOf(4, {101, 91});
  p.deform.list[0].push.on = true;
  sim::ColliderShape ball;
  ball.radius = 0.5F;
  ball.position = glm::vec3(0.013F, 0.11F, 0.017F);
  const Deformed d(p, 0, {ball});
  int moved = 0;
  for (std::size_t i = 0; i < d.mesh.positions.size(); ++i) {
    const glm::vec3 v(d.cpu.positions()[i]);
    CHECK(glm::length(v - ball.position.at(0)) > 0.4999F);
    moved += v == d.mesh.positions[i] ? 0 : 1;
  }
  CHECK(moved > 100);
}

TEST_CASE("a blade of grass below a ball is bent to the ground, and does not become wider than twice") {
  auto p = planeOf(1, {2, 2});
  p.shape = sim::MeshShape::grass;
  p.blades = 3000;
  p.deform.list[0].push.on = true;
  p.deform.list[0].push.height = 0.05F;
  sim::ColliderShape ball;
  ball.radius = 0.5F;
  ball.position = glm::vec3(0.01F, 0.5F, 0.02F);
  const Deformed d(p, 0, {ball});
  int below = 0;
  for (std::size_t i = 0; i < d.mesh.positions.size(); ++i) {
    const glm::vec3 rest = d.mesh.positions[i];
    if (std::hypot(rest.x, rest.z) > 0.2F) continue;
    CHECK(d.cpu.positions()[i].y < 0.2F);
    below += rest.y > 0.3F ? 1 : 0;
  }
  CHECK(below > 20);
  const auto lengthOf = [](const auto& from, unsigned a, unsigned b) {
    return glm::distance(glm::vec3(from[a]), glm::vec3(from[b]));
  };
  float widest = 0;
  for (std::size_t i = 0; i < d.mesh.indices.size(); ++i) {
    const unsigned a = d.mesh.indices[i], b = d.mesh.indices[i % 3 == 2 ? i - 2 : i + 1];
    if (d.mesh.positions[a].y != d.mesh.positions[b].y) continue;
    const float before = lengthOf(d.mesh.positions, a, b);
    if (before > 1e-4F) widest = std::max(widest, lengthOf(d.cpu.positions(), a, b) / before);
  }
  CHECK(widest > 1.2F);
  CHECK(widest < 3);
}

TEST_CASE("duplicate vertices at a seam share a normal; without usable faces the rest normal is kept") {
  sim::MeshParameters p;
  p.shape = sim::MeshShape::torus;
  p.resolution = {31, 17};
  p.deform.list.resize(1);
  p.deform.list[0].waves.resize(1);
  const Deformed torus(p, 0.4);
  for (std::size_t row = 0; row < 17; ++row)
    CHECK(torus.cpu.normals()[row * 31] == torus.cpu.normals()[row * 31 + 30]);
  for (std::size_t i = 0; i < 31; ++i) CHECK(torus.cpu.normals()[i] == torus.cpu.normals()[16 * 31 + i]);

  // The mesh has two triangles that share an edge with a third and a fourth (non-manifold), a degenerate
  // triangle, and an isolated vertex.
  sim::Mesh odd;
  odd.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0, -1}, {0, 1, 0}, {0, -1, 0}, {5, 5, 5}, {0.5F, 0, 0}};
  odd.normals.assign(7, glm::vec3(0, 1, 0));
  odd.indices = {0, 1, 2, 0, 1, 3, 1, 0, 4, 0, 6, 1, 0, 1, 2};
  const sim::RestMesh rest("odd", odd);
  sim::DeformCpu cpu(rest, {2, 2});
  shader::DeformStep still{};
  still.trail.cells = {2, 2};
  cpu.displace(still, sim::Threads::one);
  cpu.gatherNormals(sim::Threads::one);
  for (std::size_t i = 0; i < 7; ++i) CHECK(glm::length(glm::vec3(cpu.normals()[i])) == doctest::Approx(1));
  CHECK(cpu.normals()[5] == glm::vec4(0, 1, 0, 0));
  CHECK(cpu.normals()[6] == glm::vec4(0, 1, 0, 0));
}

TEST_CASE("sway: what a scene leaves out follows from the size of the mesh") {
  sim::Sway sway;
  sway.fitted = {true, true, true, true};
  const sim::Sway large = sway.onMesh(-20, 80), small = sway.onMesh(0, 0.1F);
  CHECK(large.base == -20);
  CHECK(large.height == 100);
  CHECK(large.amplitude == doctest::Approx(20));
  CHECK(large.wavelength == 300);
  CHECK(small.amplitude == doctest::Approx(0.02));
  sway.base = 30;
  sway.fitted = {true, false, true, false};
  CHECK(sway.onMesh(-20, 80).height == 50);
  CHECK(sway.onMesh(-20, 80).wavelength == sim::Sway().wavelength);
  CHECK(sway.onMesh(0, 10).height == sim::Sway().height);  // The mesh lies below the base.
}

TEST_CASE("an invalid deformation is reported") {
  CHECK(test::has(
      deformFailure(R"("deform": [{}])"),
      "entry 0 names 0 displacements; it must name exactly one of \"ripple\", \"waves\", \"sway\""));
  CHECK(test::has(deformFailure(R"("deform": [{"ripple": {}, "push": {}}])"),
                  "entry 0 names 2 displacements"));
  CHECK(test::has(deformFailure(R"("deform": [{"footprints": {}}, {"footprints": {}}])"), "one trail"));
  CHECK(test::has(deformFailure(R"("deform": [{"rippel": {}}])"), "ripple"));
  CHECK(test::has(deformFailure(R"("technique": "gpu")"), "vertex-shader"));
  CHECK(test::has(deformFailure(R"("deform": [{"ripple": {"wavelength": 0.001}}], "size": [8, 0, 8])"),
                  "too short"));
  CHECK(test::has(deformFailure(R"("shape": "file")"), "needs \"file\""));
  CHECK(test::has(deformFailure(R"("shape": "torus", "tube": 2)"), "closes the hole"));
  CHECK(test::has(deformFailure(R"("resolution": [16384, 16384])"), "more than 8000000 vertices"));
  CHECK(test::has(deformFailure(R"("shape": "sphere", "resolution": [3, 2])"), "at least [4, 3]"));
  std::string waves = R"({"length": 1})";
  for (int i = 0; i < 16; ++i) waves += R"(,{"length": 1})";
  CHECK(test::has(deformFailure(R"("deform": [{"waves": [)" + waves + "]}]"), "17 displacements"));
  sim::Mesh fan;
  fan.positions.assign(20'003, glm::vec3(0));
  for (unsigned i = 1; i < 20'003; ++i) fan.positions[i] = {static_cast<float>(i), 1, 0};
  fan.normals.assign(20'003, glm::vec3(0, 1, 0));
  for (unsigned i = 1; i + 1 < 20'003; ++i) fan.indices.insert(fan.indices.end(), {0, i, i + 1});
  CHECK_THROWS_WITH_AS(sim::RestMesh("fan", fan), doctest::Contains("vertex 0"), UserError);
}
