// Tests bending of meshes by comparison with closed forms of a plate.
#include "reference/garment_twin.hpp"
#include "sim/garment/plate.hpp"
#include "unit/help.hpp"
#include "unit/sim/garment_help.hpp"

#include <cmath>
#include <cstddef>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

struct PlateShape {
  double a, b, c;  ///< coefficients of the quadratic surface y = (a x^2 + 2 b x z + c z^2) / 2, 1/m
  [[nodiscard]] double at(const glm::dvec3& p) const {
    return 0.5 * (a * p.x * p.x + 2 * b * p.x * p.z + c * p.z * p.z);
  }
};

constexpr test::Kind meshKinds[] = {test::Kind::right, test::Kind::equilateral, test::Kind::random};
constexpr PlateShape plateShapes[] = {{0.02, 0, 0}, {0, 0.02, 0}, {0, 0, -0.02}, {0.01, -0.02, 0.015}};

std::vector<glm::dvec3> bentCloth(const sim::ClothTriangles& cloth, const PlateShape& q) {
  std::vector<glm::dvec3> points = cloth.points;
  for (glm::dvec3& p : points) p.y = q.at(p);
  return points;
}

}  // namespace

TEST_CASE(
    "garment: the bending energy of z = (a x^2 + 2 b x y + c y^2) / 2 inside is a plate's, on any mesh") {
  for (const auto kind : meshKinds)
    for (const PlateShape& q : plateShapes) {
      const sim::ClothTriangles cloth("a", test::rectangle(kind, {30, 22}, 0.01), 1, 0);
      std::vector<sim::PlateElement> within;
      double area = 0;
      const auto elements = sim::plateElements(cloth);
      for (std::size_t f = 0; f < elements.size(); ++f) {
        bool inside = true;
        for (const unsigned neighbour : cloth.faces[f].neighbours)
          inside = inside && neighbour != sim::ClothTriangles::none;
        if (!inside) continue;
        within.push_back(elements[f]);
        area += elements[f].area;
      }
      CHECK(area > 0.75 * 0.3 * 0.22 * (kind == test::Kind::equilateral ? 0.866 : 1));
      const double energy = sim::plateEnergy(within, 3, bentCloth(cloth, q));
      CHECK(
          energy ==
          doctest::Approx(0.5 * 3 * area * (q.a * q.a + 2 * q.b * q.b + q.c * q.c)).epsilon(1e-6).scale(0));
    }
}

TEST_CASE("garment: constant curvature exerts no force on inner vertices, and flat cloth none at all") {
  for (const auto kind : meshKinds)
    for (const PlateShape& q : plateShapes) {
      const sim::ClothTriangles cloth("a", test::rectangle(kind, {16, 13}, 0.02), 1, 0);
      const std::vector<double> masses(cloth.points.size(), 1);
      const sim::PlateMatrix matrix(sim::plateElements(cloth), 1, masses, 1e30);
      CHECK(matrix.softened == 0);
      const auto points = bentCloth(cloth, q);
      double minimum = 1e30;
      double tilted = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        double size = 0;
        double force = 0;
        double tilt = 0;
        for (const auto& [j, value] : matrix.rows[i]) {
          size += std::abs(value) * std::abs(q.at(cloth.points[j]));
          force -= value * (points[j].y - points[i].y);
          tilt -= value * (cloth.points[j].x - cloth.points[i].x);
        }
        tilted = std::max(tilted, std::abs(tilt));
        const glm::dvec3 p = cloth.points[i];
        if (std::abs(p.x) < 0.5 * 0.32 - 0.09 && std::abs(p.z) < 0.5 * 0.26 * 0.86 - 0.07) {
          minimum = std::min(minimum, size);
          CHECK(std::abs(force) < 1e-7);
        }
      }
      CHECK(tilted < 1e-6);
      CHECK(minimum > 1e-4);
    }
}

TEST_CASE("garment: a clamped strip of any mesh bends by q L^4 / 8 D") {
  constexpr double length = 0.2;
  constexpr double q = 0.115 * 0.098;  // weight per area, N/m^2
  constexpr double bending = 7.5e-4;
  const double expected = q * std::pow(length, 4) / (8 * bending);  // The end drops by 0.015 of the length.
  for (const auto kind : meshKinds)
    for (const int cells : {8, 12, 16}) {
      CAPTURE(cells);
      CAPTURE(static_cast<int>(kind));
      // Two columns of vertices are fixed, so the strip is clamped midway between them.
      const double cell = length / (cells - 0.5);
      const test::TemporaryFile file("strip.obj", test::objOf(test::rectangle(kind, {cells, 3}, cell, 2)));
      sim::ClothParameters p = test::freeCloth();
      p.mesh->shape = sim::ClothShape::file;
      p.mesh->file = file.path();
      p.gravity = glm::vec3(0, -0.098F, 0);
      p.damping = 10;
      p.fabric->bending = bending;
      test::pinBox(p, glm::vec3(-9), glm::vec3(static_cast<float>(cell * (1.2 - 0.5 * cells)), 9, 9));
      GarmentTwin twin(sim::GarmentPlan("strip", p, 1, 1.0 / 60, {}));
      for (int frame = 0; frame < 150; ++frame) twin.step(frame / 60.0);
      double drop = 0;
      int ends = 0;
      for (const glm::vec4& v : twin.positions)
        if (v.x > cell * (0.5 * cells - 0.1)) {
          drop -= v.y;
          ++ends;
        }
      CHECK(ends == 4);
      CHECK(drop / ends == doctest::Approx(expected).epsilon(0.03).scale(0));
    }
}

TEST_CASE("garment: sliver triangles are softened until bending is stable at the given step") {
  sim::Mesh mesh = test::rectangle(test::Kind::right, {12, 12}, 0.01);
  mesh.positions[6 * 13 + 6].x += 0.00995F;  // The displacement of one vertex makes some faces very thin.
  const sim::ClothTriangles cloth("a", mesh, 1, 0);
  const auto elements = sim::plateElements(cloth);
  const std::vector<double> inverse(cloth.points.size(), 1e5);
  const double bound = sim::plateFrequencySquared(elements, 1e-5, inverse, 0.5);
  CHECK(sim::plateFrequencySquared(elements, 1e-5, inverse, 1) > 10 * bound);
  const sim::PlateMatrix matrix(elements, 1e-5, inverse, 2 * bound);
  CHECK(matrix.softened > 4);
  CHECK(matrix.softened < 144);
  for (std::size_t i = 0; i < matrix.rows.size(); ++i) {
    double sum = 0;
    double diagonal = 0;
    for (const auto& [j, value] : matrix.rows[i]) {
      sum += std::abs(value);
      diagonal -= value;
      for (const auto& [back, other] : matrix.rows[j])
        if (back == i) CHECK(other == doctest::Approx(value).epsilon(1e-9).scale(1e-12));
    }
    CHECK((sum + diagonal) * inverse[i] <= 2.0001 * bound);
  }
}

TEST_CASE("garment: a clamped border bends by q L^4 / 8 D and rotates with its pins") {
  constexpr double length = 0.2;
  constexpr double q = 0.115 * 0.098;  // weight per area, N/m^2
  constexpr double bending = 7.5e-4;
  const double expected = q * std::pow(length, 4) / (8 * bending);
  std::vector<double> drops;
  for (const auto kind : meshKinds)
    for (const int cells : {8, 12, 16}) {
      CAPTURE(cells);
      CAPTURE(static_cast<int>(kind));
      const double cell = length / cells;
      const test::TemporaryFile file("strip.obj", test::objOf(test::rectangle(kind, {cells, 3}, cell)));
      sim::ClothParameters p = test::freeCloth();
      p.mesh->shape = sim::ClothShape::file;
      p.mesh->file = file.path();
      p.gravity = glm::vec3(0, -0.098F, 0);
      p.damping = 10;
      p.fabric->bending = bending;
      test::pinBox(p, glm::vec3(-9), glm::vec3(static_cast<float>(cell * (0.2 - 0.5 * cells)), 9, 9));
      p.pins[0].clamp = true;
      GarmentTwin twin(sim::GarmentPlan("strip", p, 1, 1.0 / 60, {}));
      CHECK(twin.positions.size() == twin.plan().masses().size() + 3);
      for (int frame = 0; frame < 150; ++frame) twin.step(frame / 60.0);
      double drop = 0;
      int ends = 0;
      for (std::size_t i = 0; i < twin.plan().masses().size(); ++i)
        if (twin.positions[i].x > cell * (0.5 * cells - 0.1)) {
          drop -= twin.positions[i].y;
          ++ends;
        }
      CHECK(ends == 4);
      drops.push_back(drop / ends);
      CHECK(drops.back() == doctest::Approx(expected).epsilon(0.03));
    }
  // The strip is clamped at an angle of two degrees and weightless, so it continues straight in that
  // direction.
  sim::ClothParameters p = test::freeCloth();
  p.mesh->size = glm::vec3(0.2F, 0, 0.06F);
  p.mesh->resolution = {9, 4};
  p.damping = 10;
  p.fabric->bending = bending;
  test::pinBox(p, glm::vec3(-9), glm::vec3(-0.099F, 9, 9));
  p.pins[0].clamp = true;
  p.pins[0].pivot = glm::vec3(-0.1F, 0, 0);
  p.pins[0].rotate = glm::vec3(0, 0, 2);
  GarmentTwin twin(sim::GarmentPlan("strip", p, 1, 1.0 / 60, {}));
  for (int frame = 0; frame < 120; ++frame) twin.step(frame / 60.0);
  for (std::size_t i = 0; i < twin.plan().masses().size(); ++i)
    CHECK(twin.positions[i].y ==
          doctest::Approx((twin.positions[i].x + 0.1) * std::tan(2 * 3.14159265 / 180))
              .epsilon(0.02)
              .scale(5e-4));
}
