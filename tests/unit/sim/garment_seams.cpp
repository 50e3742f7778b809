// Tests that closed seams bend like the cloth around them.
#include "reference/garment_twin.hpp"
#include "sim/garment/plate.hpp"
#include "unit/help.hpp"
#include "unit/sim/garment_help.hpp"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

constexpr int seamCells = 6;       // number of cells along each piece
constexpr double seamGap = 0.001;  // gap between the pieces, m

/// Returns a strip of twice `seamCells` by 3 cells that consists of two pieces. The second piece is
/// displaced by `seamGap`.
sim::Mesh twoPieces(test::Kind kind, double cell) {
  sim::Mesh mesh = test::rectangle(kind, {seamCells, 3}, cell, 2);
  const sim::Mesh other = test::rectangle(kind, {seamCells, 3}, cell);
  const auto first = static_cast<unsigned>(mesh.positions.size());
  for (const glm::vec3& p : other.positions)
    mesh.positions.push_back(p + glm::vec3(static_cast<float>(seamCells * cell + seamGap), 0, 0));
  mesh.uvs.insert(mesh.uvs.end(), other.uvs.begin(), other.uvs.end());
  for (const unsigned i : other.indices) mesh.indices.push_back(i + first);
  return mesh;
}

/// Returns a seam of pairs of vertices, one on each side of the gap.
sim::Seam seamOf(const sim::Mesh& mesh, double border) {
  sim::Seam seam;
  seam.seconds = 0.1;
  for (int i = 0; i < static_cast<int>(mesh.positions.size()); ++i)
    for (int j = 0; j < static_cast<int>(mesh.positions.size()); ++j) {
      const glm::dvec3 a = mesh.positions[static_cast<std::size_t>(i)];
      const glm::dvec3 b = mesh.positions[static_cast<std::size_t>(j)];
      if (std::abs(a.x - border) < 1e-5 && std::abs(b.x - border - seamGap) < 1e-5 &&
          std::abs(a.z - b.z) < 1e-5) {
        seam.from.push_back(i);
        seam.to.push_back(j);
      }
    }
  return seam;
}

}  // namespace

TEST_CASE("garment: a strip sewn from two pieces bends by q L^4 / 8 D like one piece") {
  constexpr double length = 0.2;
  constexpr double q = 0.115 * 0.098;  // weight per area, N/m^2
  constexpr double bending = 7.5e-4;
  const double expected = q * std::pow(length, 4) / (8 * bending);
  for (const auto kind : {test::Kind::right, test::Kind::equilateral, test::Kind::random}) {
    CAPTURE(static_cast<int>(kind));
    const double cell =
        length / (2 * seamCells - 0.5);  // The strip is clamped between the first two columns.
    const test::TemporaryFile file("sewn.obj", test::objOf(twoPieces(kind, cell)));
    sim::ClothParameters p = test::freeCloth();
    p.mesh->shape = sim::ClothShape::file;
    p.mesh->file = file.path();
    p.gravity = glm::vec3(0, -0.098F, 0);
    p.damping = 10;
    p.fabric->bending = bending;
    p.seams.push_back(seamOf(p.mesh->make(), 0.5 * seamCells * cell));
    REQUIRE(p.seams[0].from.size() == 4);
    test::pinBox(p, glm::vec3(-9), glm::vec3(static_cast<float>(cell * (1.2 - 0.5 * seamCells)), 9, 9));
    GarmentTwin twin(sim::GarmentPlan("strip", p, 1, 1.0 / 60, {}));
    CHECK(twin.plan().arrays().bendings.size() == 2);
    CHECK(twin.plan().bendingAt(0) == 0);
    for (int frame = 0; frame < 180; ++frame) twin.step(frame / 60.0);
    CHECK(twin.plan().bendingAt(twin.plan().substeps() * 180) == 1);
    double drop = 0;
    int ends = 0;
    for (const glm::vec4& v : twin.positions)
      if (v.x > cell * (1.5 * seamCells - 0.1) - 0.001) {
        drop -= v.y;
        ++ends;
      }
    CHECK(ends == 4);
    CHECK(drop / ends == doctest::Approx(expected).epsilon(0.04));
  }
}

TEST_CASE("garment: sewn cloth equals cloth of one mesh, to the last weight") {
  const double cell = 0.1;
  const sim::Mesh pieces = twoPieces(test::Kind::right, cell);
  sim::ClothTriangles sewn("pieces", pieces, 1, 0);
  const sim::Seam seam = seamOf(pieces, 0.5 * seamCells * cell);
  std::vector<std::pair<unsigned, unsigned>> stitches;
  for (std::size_t i = 0; i < seam.from.size(); ++i)
    stitches.emplace_back(sewn.vertexOf[static_cast<std::size_t>(seam.from[i])],
                          sewn.vertexOf[static_cast<std::size_t>(seam.to[i])]);
  CHECK(sewn.sew(stitches) == 0);
  // Both pieces have the shape z = (a x^2 + 2 b x y + c y^2) / 2, ignoring the gap. The energy must equal
  // the energy of a plate, even in the faces at the seam.
  std::vector<glm::dvec3> points = sewn.points;
  for (glm::dvec3& p : points) {
    if (p.x > 0.5 * seamCells * cell + 0.5 * seamGap) p.x -= seamGap;
    p.y = 0.5 * (0.02 * p.x * p.x - 0.06 * p.x * p.z + 0.01 * p.z * p.z);
  }
  const auto elements = sim::plateElements(sewn);
  std::vector<sim::PlateElement> within;
  double area = 0;
  for (std::size_t f = 0; f < elements.size(); ++f) {
    bool inside = true;
    for (const unsigned neighbour : sewn.faces[f].neighbours)
      inside = inside && neighbour != sim::ClothTriangles::none;
    if (!inside) continue;
    within.push_back(elements[f]);
    area += elements[f].area;
  }
  CHECK(area == doctest::Approx(44 * 0.5 * cell * cell));  // 28 of the 72 faces are at borders and are not
                                                           // included.
  CHECK(sim::plateEnergy(within, 3, points) ==
        doctest::Approx(0.5 * 3 * area * (0.02 * 0.02 + 2 * 0.03 * 0.03 + 0.01 * 0.01)).epsilon(1e-5));
  // The two pieces have opposite orientations, so they are not joined smoothly.
  sim::Mesh turned = pieces;
  for (std::size_t i = turned.indices.size() / 2; i < turned.indices.size(); i += 3)
    std::swap(turned.indices[i], turned.indices[i + 1]);
  sim::ClothTriangles opposite("pieces", turned, 1, 0);
  CHECK(opposite.sew(stitches) == 3);
}
