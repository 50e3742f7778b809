// Tests meshes as cloth: refused meshes with the position of the error, welding, neighbours, colours, and
// generators.
#include "base/error.hpp"
#include "sim/cloth/mesh_source.hpp"
#include "sim/garment/triangles.hpp"
#include "unit/help.hpp"
#include "unit/sim/garment_help.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

std::string clothRefusal(const sim::Mesh& mesh) {
  try {
    static_cast<void>(sim::ClothTriangles("cloth \"a\"", mesh, 1, 0));
  } catch (const UserError& error) {
    CHECK(error.code() == ExitCode::usage);
    return error.what();
  }
  return "";
}

sim::Mesh clothSquare() {
  sim::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 1}};
  mesh.normals.assign(4, glm::vec3(0, 1, 0));
  mesh.indices = {0, 1, 2, 2, 1, 3};
  return mesh;
}

double areaOf(const sim::ClothTriangles& cloth) {
  double sum = 0;
  for (const auto& face : cloth.faces) sum += face.area;
  return sum;
}

int bordersOf(const sim::ClothTriangles& cloth) {
  int borders = 0;
  for (const auto& face : cloth.faces)
    for (const unsigned neighbour : face.neighbours)
      borders += neighbour == sim::ClothTriangles::none ? 1 : 0;
  return borders;
}

}  // namespace

TEST_CASE("garment: a mesh that is not usable as cloth is refused with the place") {
  CHECK(clothRefusal(clothSquare()).empty());
  sim::Mesh fold = clothSquare();
  fold.positions.emplace_back(0.5F, 1.0F, 0.5F);
  fold.indices.insert(fold.indices.end(), {2, 1, 4});
  test::checkHas(clothRefusal(fold), "cloth \"a\": an edge belongs to 3 faces (0, 1, 2");
  test::checkHas(clothRefusal(fold), "at (0, 0, 1)");
  sim::Mesh turned = clothSquare();
  std::swap(turned.indices[4], turned.indices[5]);
  test::checkHas(clothRefusal(turned), "faces 0 and 1 face opposite ways");
  sim::Mesh flat = clothSquare();
  flat.positions[3] = {0.5F, 0, 0.5F};
  test::checkHas(clothRefusal(flat), "face 1 (vertices 2, 1 and 3) has no area, at (1, 0, 0)");
  sim::Mesh loose = clothSquare();
  loose.positions.emplace_back(7.0F, 8.0F, 9.0F);
  loose.normals.emplace_back(0.0F, 1.0F, 0.0F);
  sim::Mesh fan;
  fan.positions.emplace_back(1.0F, 2.0F, 3.0F);
  for (unsigned i = 0; i < 300; ++i) {
    const double angle = 2 * std::numbers::pi * i / 300;
    fan.positions.emplace_back(1 + std::sin(angle), 2, 3 + std::cos(angle));
    fan.indices.insert(fan.indices.end(), {0, 1 + i, 1 + (i + 1) % 300});
  }
  fan.normals.assign(301, glm::vec3(0, 1, 0));
  test::checkHas(clothRefusal(fan), "300 faces meet in one vertex, at (1, 2, 3)");
  test::checkHas(clothRefusal(loose), "vertex 4 belongs to no face, at (7, 8, 9)");
}

TEST_CASE("garment: vertices at equal positions, or within the weld distance, are merged") {
  sim::Mesh mesh = clothSquare();  // The second face has vertices of its own.
  mesh.positions.insert(mesh.positions.end(), {{1, 0, 0}, {0, 0, 1}});
  mesh.normals.assign(6, glm::vec3(0, 1, 0));
  mesh.indices = {0, 1, 2, 4, 5, 3};
  const sim::ClothTriangles joined("a", mesh, 2, 0);
  CHECK(joined.points.size() == 4);
  CHECK(joined.vertexOf == std::vector<unsigned>{0, 1, 2, 3, 2, 1});
  CHECK(joined.faces[0].neighbours[1] == 1);
  CHECK(joined.faces[0].beyond[1] == 3);
  CHECK(areaOf(joined) == doctest::Approx(4));
  mesh.positions[4].x = 1.01F;
  mesh.positions[5].z = 1.01F;
  CHECK(sim::ClothTriangles("a", mesh, 1, 0).points.size() == 6);
  CHECK(sim::ClothTriangles("a", mesh, 1, 0.009).points.size() == 6);
  CHECK(sim::ClothTriangles("a", mesh, 1, 0.011).points.size() == 4);
  // The welding distance applies to the scaled mesh.
  CHECK(sim::ClothTriangles("a", mesh, 2, 0.011).points.size() == 6);
}

TEST_CASE("garment: faces of one colour share no vertex, and few colours are used") {
  for (const auto kind : {test::Kind::right, test::Kind::equilateral, test::Kind::random}) {
    const sim::ClothTriangles cloth("a", test::rectangle(kind, {37, 29}, 0.01), 1, 0);
    const std::vector<int> colours = sim::colourFaces(cloth);
    const int count = *std::max_element(colours.begin(), colours.end()) + 1;
    unsigned maximum = 0;
    for (std::size_t i = 0; i < cloth.points.size(); ++i)
      maximum = std::max(maximum, cloth.starts[i + 1] - cloth.starts[i]);
    CHECK(count <= static_cast<int>(maximum) + 3);
    std::vector<int> seen(cloth.points.size(), -1);
    for (int colour = 0; colour < count; ++colour)
      for (std::size_t f = 0; f < colours.size(); ++f)
        if (colours[f] == colour)
          for (const unsigned corner : cloth.faces[f].corners) {
            CHECK(seen[corner] != colour);
            seen[corner] = colour;
          }
  }
}

TEST_CASE("garment: generated shapes are closed, face outwards and have the right area") {
  constexpr double pi = std::numbers::pi;
  sim::ClothMesh source;
  source.radius = 0.5F;
  source.tube = 0.2F;
  source.length = 1.2F;
  source.resolution = {65, 49};
  struct Expected {
    sim::ClothShape shape;
    double area;
    int borders;
  };
  for (const Expected e :
       {Expected{sim::ClothShape::plane, 4, 2 * (64 + 48)},
        Expected{sim::ClothShape::disc, 0.25 * pi, 6 * 32}, Expected{sim::ClothShape::sphere, pi, 0},
        Expected{sim::ClothShape::cylinder, 1.2 * pi, 2 * 65},
        Expected{sim::ClothShape::torus, 4 * pi * pi * 0.1, 0}}) {
    source.shape = e.shape;
    CAPTURE(source.text());
    const sim::Mesh mesh = source.make();
    const sim::ClothTriangles cloth("a", mesh, 1, 0);
    CHECK(areaOf(cloth) == doctest::Approx(e.area).epsilon(0.005));
    CHECK(bordersOf(cloth) == e.borders);
    std::vector<std::size_t> first(cloth.points.size());  // index in the mesh of the first vertex at each
                                                          // welded point
    for (std::size_t v = cloth.vertexOf.size(); v-- > 0;) first[cloth.vertexOf[v]] = v;
    for (const auto& face : cloth.faces) {
      const glm::dvec3 a = cloth.points[face.corners[0]];
      const glm::dvec3 n = glm::cross(cloth.points[face.corners[1]] - a, cloth.points[face.corners[2]] - a);
      const glm::dvec3 outwards(mesh.normals[first[face.corners[0]]]);
      REQUIRE(glm::dot(n, outwards) > 0);
    }
  }
}
