// Tests distance fields of meshes by comparison with closed forms and with an independent implementation in
// double precision. Also tests that each error gives a clear one-line message.
#include "base/error.hpp"
#include "reference/distance_twin.hpp"
#include "sim/mesh/shapes.hpp"
#include "sim/world/world.hpp"
#include "unit/help.hpp"
#include "unit/sim/collide_help.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

DistanceTwin fieldOf(const std::string& mesh, double reach = 0.05) {
  return DistanceTwin(sim::MeshColliderPlan(test::parsedScene(test::meshObject(mesh)), reach));
}

/// Returns a sphere with dents and spikes.
sim::Mesh burr() {
  sim::Mesh mesh = sim::sphereMesh(1, {41, 27});
  for (glm::vec3& p : mesh.positions)
    p *= 1 + 0.45F * std::sin(9 * p.x + 1) * std::sin(11 * p.y) * std::sin(8 * p.z + 2);
  return mesh;
}

std::string firstProblem(const std::string& objects) {
  try {
    const auto problems = sim::findProblems(test::parsedScene(objects));
    return problems.empty() ? "none" : fmt::format("{} ({})", problems.front().what(), problems.size());
  } catch (const UserError& error) {
    return error.what();
  }
}

}  // namespace

TEST_CASE(
    "collide: the field of a ball and of a torus equals the closed form within the cells' resolution") {
  // A mesh with chords lies inside its circle by R (1 - cos(pi / n)). The error of interpolation in a cell
  // is h^2 / 8 times the curvature.
  test::Draws draws;
  const DistanceTwin ball = fieldOf(R"("shape": "sphere", "radius": 0.5, "resolution": [129, 65])");
  const DistanceTwin torus = fieldOf(
      R"("shape": "torus", "radius": 1, "tube": 0.3, "resolution": [257, 97], "distanceCells": 100)");
  double worstBall = 0, worstTorus = 0, worstSlope = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 p = draws.inBox(glm::dvec3(0.6));
    const double size = glm::length(p);
    const glm::dvec4 found = distanceTwinAt(ball, glm::vec3(p));
    if (found.w < 1e8 && size > 0.25) {
      worstBall = std::max(worstBall, std::abs(found.w - (size - 0.5)));
      worstSlope = std::max(worstSlope, glm::length(glm::dvec3(found) - p / size));
    }
    const glm::dvec3 q = draws.inBox({1.4, 0.4, 1.4});
    const double across = std::sqrt(q.x * q.x + q.z * q.z) - 1;
    const double ring = std::sqrt(across * across + q.y * q.y);
    const glm::dvec4 there = distanceTwinAt(torus, glm::vec3(q));
    if (there.w < 1e8 && ring > 0.2 && ring < 0.8)
      worstTorus = std::max(worstTorus, std::abs(there.w - (ring - 0.3)));
  }
  CHECK(worstBall < 1e-3);   // maximum error of the sphere for cells of 0.0156 m
  CHECK(worstTorus < 2e-3);  // maximum error of the torus for cells of 0.026 m
  CHECK(worstSlope < 0.06);
}

TEST_CASE("collide: distances and sides of a burr equal double precision") {
  const sim::Mesh mesh = burr();
  const sim::DistancePlan plan("burr", mesh, 0.7F, 0, 0.05);
  const test::BruteForce brute(mesh, 0.7F);
  test::Draws draws;
  int inside = 0;
  double worst = 0;
  for (int i = 0; i < 1500; ++i) {
    const glm::dvec3 p = draws.inBox(glm::dvec3(0.9));
    const double found = distanceTo(plan, glm::vec3(p));
    const double expected = brute.distance(glm::dvec3(glm::vec3(p)));
    worst = std::max(worst, std::abs(std::abs(found) - expected));
    if (expected < 1e-5) continue;
    const bool within = brute.winding(p) > 0.5;
    inside += within ? 1 : 0;
    REQUIRE(within == (found < 0));
  }
  CHECK(inside > 200);
  CHECK(worst < 3e-6);
  // The mesh `turned` has faces that point inwards.
  sim::Mesh turned = mesh;
  for (std::size_t i = 0; i < turned.indices.size(); i += 3)
    std::swap(turned.indices[i], turned.indices[i + 1]);
  const sim::DistancePlan round("burr", turned, 0.7F, 0, 0.05);
  CHECK(distanceTo(round, glm::vec3(0.01F)) < 0);
  CHECK(distanceTo(round, glm::vec3(2)) > 0);
}

TEST_CASE("collide: a box's field is exact to rounding at its nodes and beside faces, edges and corners") {
  const test::TemporaryFile file("box.obj", test::boxObj({0.5, 0.25, 0.3}));
  const DistanceTwin twin =
      fieldOf(fmt::format(R"("shape": "file", "file": "{}", "scale": 2)", file.path().string()), 0.2);
  const sim::DistancePlan& plan = twin.plan.parts().front().plan;
  CHECK(plan.cell == doctest::Approx(2.0 / 64));
  const glm::dvec3 half(1, 0.5, 0.6);
  test::Draws draws;
  for (int i = 0; i < 4000; ++i) {
    const glm::dvec3 p = draws.inBox(half * 1.2);
    const glm::dvec3 over = glm::abs(p) - half;
    const double expected =
        glm::length(glm::max(over, 0.0)) + std::min(std::max({over.x, over.y, over.z}), 0.0);
    REQUIRE(std::abs(distanceTo(plan, glm::vec3(p)) - expected) < 2e-6);
    const double found = distanceTwinAt(twin, glm::vec3(p)).w;
    // Between two equally distant faces, the distance has a kink inside a cell.
    REQUIRE(std::abs(found - expected) < (expected > 2 * plan.cell ? 0.1 : 0.6) * plan.cell);
  }
  CHECK(distanceTwinAt(twin, glm::vec3(1.19F, 0, 0)).w == doctest::Approx(0.19).epsilon(1e-3));
  CHECK(distanceTwinAt(twin, glm::vec3(3, 0, 0)).w == 1e9F);
}

TEST_CASE("collide: the cell size follows a mesh's size and thinness") {
  const auto cellOf = [](const glm::dvec3& half, const std::string& more) {
    const test::TemporaryFile file("plate.obj", test::boxObj(half));
    const auto scene = test::parsedScene(
        test::meshObject(fmt::format(R"("shape": "file", "file": "{}"{})", file.path().string(), more)));
    const sim::MeshColliderPlan plan(scene, 0);
    return plan.parts().front().plan.cell;
  };
  CHECK(cellOf({5, 5, 5}, "") == doctest::Approx(10.0 / 64));
  CHECK(cellOf({1, 0.02, 1}, "") < 0.011F);  // The bound is about a quarter of the thickness of 0.04 m.
  CHECK(cellOf({1, 0.0005, 1}, "") == doctest::Approx(2.0 / 256));
  CHECK(cellOf({1, 1, 1}, R"(, "distanceCells": 20)") == doctest::Approx(0.1));
}

TEST_CASE("collide: a mesh that cannot collide is reported once with the reason") {
  const auto problemOf = [](const std::string& obj, const std::string& more = "") {
    const test::TemporaryFile file("bad.obj", obj);
    return firstProblem(
        test::meshObject(fmt::format(R"("shape": "file", "file": "{}"{})", file.path().string(), more)));
  };
  const std::string box = test::boxObj({1, 1, 1});
  CHECK(problemOf(box) == "none");
  const std::string open = problemOf(box.substr(0, box.rfind("f ")));
  test::checkHas(open,
                 "mesh \"solid\" collides, but is not closed: 3 of its edges have a face on one side only");
  test::checkHas(open, "close its holes");
  test::checkHas(open, "(1)");
  std::string turned = box;
  turned.replace(turned.find("f 1 3 4"), 7, "f 3 1 4");
  test::checkHas(problemOf(turned), "turned differently");
  test::checkHas(problemOf(test::boxObj({1, 1, 1}, "v 2 2 2\nf 1 3 9\nf 3 1 9\n")), "more than two faces");
  test::checkHas(problemOf("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 3 2\n"), "encloses no space");
  test::checkHas(problemOf(box, R"(, "distanceCells": 900)"), "lower \"distanceCells\" (900)");
  test::checkHas(problemOf("v 0 0 0\n"), "(1)");
  test::checkHas(firstProblem(test::meshObject(R"("shape": "plane")")), "must be closed");
  test::checkHas(
      firstProblem(test::meshObject(R"("shape": "sphere", "scale": {"keys": [[0, 1], [1, 2]]})")),
      "cannot change its size");
  test::checkHas(firstProblem(test::meshObject(R"("shape": "sphere", "distanceCells": 3)")), "at least 8");
  test::checkHas(firstProblem(test::meshObject(R"("shape": "sphere", "grip": 3, "friction": 1)")),
                 "\"grip\" or \"friction\", not both");
  test::checkHas(firstProblem(R"("m": {"mesh": {"shape": "sphere", "friction": 1}})"),
                 "\"friction\" is for a mesh with \"collides\"");
  test::checkHas(firstProblem(test::meshObject(R"("deform": [{"ripple": {}}], "friction": 1)")),
                 "is not deformed");
}
