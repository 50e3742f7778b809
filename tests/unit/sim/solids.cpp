// Tests boxes, cylinders, cones and discs as meshes.
#include "sim/mesh/shapes.hpp"
#include "sim/world/list.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

/// Returns the volume by the divergence theorem. It is positive if the triangles face outwards.
double enclosedVolume(const sim::Mesh& mesh) {
  double volume = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 a(mesh.positions[mesh.indices[i]]), b(mesh.positions[mesh.indices[i + 1]]),
        c(mesh.positions[mesh.indices[i + 2]]);
    volume += glm::dot(a, glm::cross(b, c)) / 6;
  }
  return volume;
}

/// True if each edge, identified by the positions of its ends, belongs to two triangles that traverse it in
/// opposite directions.
bool isWatertight(const sim::Mesh& mesh) {
  using Point = std::tuple<float, float, float>;
  std::map<std::pair<Point, Point>, int> edges;
  const auto point = [&](std::size_t i) {
    const glm::vec3& p = mesh.positions[mesh.indices[i]];
    return Point(p.x + 0.0F, p.y + 0.0F, p.z + 0.0F);
  };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const Point a = point(i + k), b = point(i + (k + 1) % 3);
      if (a == b) continue;  // At the tip of a cone, the edge has length 0.
      edges[{a, b}] += 1;
      edges[{b, a}] -= 1;
    }
  for (const auto& [edge, count] : edges)
    if (count != 0) return false;
  return true;
}

/// Returns the minimum cosine between a triangle's normal and the normals of its corners.
double normalAgreement(const sim::Mesh& mesh) {
  double minimum = 1;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::vec3 a = mesh.positions[mesh.indices[i]], b = mesh.positions[mesh.indices[i + 1]],
                    c = mesh.positions[mesh.indices[i + 2]];
    const glm::vec3 area = glm::cross(b - a, c - a);
    if (glm::length(area) < 1e-9F) continue;
    for (std::size_t k = 0; k < 3; ++k)
      minimum = std::min(
          minimum, static_cast<double>(glm::dot(glm::normalize(area), mesh.normals[mesh.indices[i + k]])));
  }
  return minimum;
}

// area of a regular polygon with 64 corners and circumradius 1
const double polygon = 32 * std::sin(std::numbers::pi / 32);

}  // namespace

TEST_CASE("solids: volumes are those of the polyhedra, and faces look outwards") {
  CHECK(enclosedVolume(sim::boxMesh({2, 3, 0.5F})) == doctest::Approx(3).epsilon(1e-6));
  CHECK(enclosedVolume(sim::cylinderMesh(0.7F, 0.7F, 2)) ==
        doctest::Approx(polygon * 0.49 * 2).epsilon(1e-6));
  CHECK(enclosedVolume(sim::cylinderMesh(0, 0.7F, 3)) == doctest::Approx(polygon * 0.49).epsilon(1e-6));
  // The volume of a frustum of height h with end areas A and B is h / 3 (A + B + sqrt(A B)).
  CHECK(enclosedVolume(sim::cylinderMesh(1, 2, 3)) == doctest::Approx(polygon * 7).epsilon(1e-6));
  for (const sim::Mesh& mesh : {sim::boxMesh({2, 3, 0.5F}), sim::cylinderMesh(0.7F, 0.7F, 2),
                                sim::cylinderMesh(0, 0.7F, 3), sim::discMesh(2)})
    CHECK(normalAgreement(mesh) > 0.99);
}

TEST_CASE("solids: boxes, cylinders and cones are closed, and a disc is not") {
  CHECK(isWatertight(sim::boxMesh({1, 2, 3})));
  CHECK(isWatertight(sim::cylinderMesh(1, 1, 1)));
  CHECK(isWatertight(sim::cylinderMesh(0, 1, 1)));
  CHECK_FALSE(isWatertight(sim::discMesh(1)));
}

TEST_CASE("solids: each kind has its own parameters and bounds around the origin") {
  for (const char* name : {"box", "cylinder", "cone", "torus", "disc"}) {
    CAPTURE(name);
    const auto parameters = sim::simulationNamed(name).kind.makeParameters();
    const auto box = parameters->framed();
    REQUIRE(box.has_value());
    CHECK(box->max.x == doctest::Approx(-box->min.x));
    CHECK(box->max.y == doctest::Approx(-box->min.y));
  }
}
