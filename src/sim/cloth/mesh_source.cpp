#include "sim/cloth/mesh_source.hpp"

#include "base/ieee.hpp"
#include "scene/value/implied_shape.hpp"
#include "sim/mesh/shapes.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr std::int64_t maxClothVertices = 250'000;  // limits memory, because ClothPlan needs 6 kB per
                                                    // vertex

/// Returns the point of the unit circle at the fraction `part` of a turn, starting from +z.
glm::dvec2 onCircle(double part) {
  const double angle = 2.0 * std::numbers::pi * part;
  return {ieee::sin(angle), ieee::cos(angle)};
}

}  // namespace

void ClothMesh::describe(scene::Fields& f) {
  f.choice("shape", shape, {"plane", "disc", "sphere", "cylinder", "torus", "file"},
           "Shape that is generated, or \"file\": read from a file.");
  f.asset("file", file, "OBJ, PLY, glTF or GLB, in m; its parts are pieces of the cloth.");
  scene::implyShape(f, shape, ClothShape::file, "file", file, "file", "plane");
  f.vector("size", size, {0, 1e4}, "m", "Width and depth of a plane (x and z).");
  f.number("radius", radius, {1e-4, 1e4}, "m",
           "Radius of a disc, sphere or cylinder; of a torus, the distance to the middle of its tube.");
  f.number("tube", tube, {1e-4, 1e4}, "m", "Radius of a torus' tube.");
  f.number("length", length, {1e-4, 1e4}, "m", "Length of a cylinder, which is an open tube along y.");
  f.pair("resolution", resolution, {3, 4096}, "vertices",
         "Vertices along u and v: along x and z of a plane; around and along a cylinder; along and around "
         "the tube of a torus. For a disc the first number counts vertices across it, for a sphere along "
         "each of its six grids.");
  f.number("scale", scale, {1e-6, 1e6}, "", "Factor on the mesh's coordinates.");
  f.number("weld", weld, {0, 10}, "m",
           "Distance within which vertices become one. 0 joins vertices at the same place, which files "
           "split for uv and normals.");
  if (shape == ClothShape::file && file.empty())
    f.error("shape", "the shape \"file\" needs \"file\": the mesh to read");
  if (shape == ClothShape::torus && tube >= radius)
    f.error("tube", fmt::format("a tube of {} m closes the hole of a torus of {} m", tube, radius));
  if (shape == ClothShape::plane && (size.x < 1e-4F || size.z < 1e-4F))
    f.error("size", "a plane is at least 0.0001 m wide and deep");
  const char* const ruler = f.given("shape") ? "shape" : "file";
  const bool cylinder = shape == ClothShape::cylinder, torus = shape == ClothShape::torus;
  f.idleUnless(shape == ClothShape::plane, ruler, {"size"}, "a \"plane\"");
  f.idleUnless(cylinder || torus || shape == ClothShape::disc || shape == ClothShape::sphere, ruler,
               {"radius"}, "a \"disc\", \"sphere\", \"cylinder\" or \"torus\"");
  f.idleUnless(torus, ruler, {"tube"}, "a \"torus\"");
  f.idleUnless(cylinder, ruler, {"length"}, "a \"cylinder\"");
  f.idleUnless(shape != ClothShape::file, ruler, {"resolution"}, "what is generated");
  if (std::int64_t{resolution.x} * resolution.y > maxClothVertices)
    f.error("resolution",
            fmt::format("{}x{} are more than {} vertices", resolution.x, resolution.y, maxClothVertices));
}

Mesh ClothMesh::make() const {
  switch (shape) {
    case ClothShape::plane:
      return planeMesh(size, resolution);
    case ClothShape::disc:
      return discMesh(radius, resolution.x / 2);
    case ClothShape::sphere:
      return cubedSphereMesh(radius, resolution.x);
    case ClothShape::cylinder:
      return tubeMesh(radius, length, resolution + glm::ivec2(1, 0));
    case ClothShape::torus:
      return torusMesh(radius, tube, resolution + 1);
    case ClothShape::file:
      break;
  }
  return loadMesh(file, MeshNormals::shared);
}

std::string ClothMesh::text() const {
  constexpr const char* names[] = {"plane", "disc", "sphere", "cylinder", "torus"};
  return shape == ClothShape::file ? file.filename().string() : names[static_cast<std::size_t>(shape)];
}

Mesh discMesh(float radius, int rings) {
  Mesh mesh;
  const auto add = [&](glm::dvec2 place) {
    mesh.positions.emplace_back(radius * place.x, 0.0, radius * place.y);
    mesh.normals.emplace_back(0, 1, 0);
    mesh.uvs.emplace_back(0.5 + 0.5 * place.x, 0.5 + 0.5 * place.y);
  };
  add({0, 0});
  for (int ring = 1; ring <= rings; ++ring)
    for (int k = 0; k < 6 * ring; ++k)
      add(onCircle(k / (6.0 * ring)) * (static_cast<double>(ring) / rings));
  const auto number = [](int ring, int k) {
    return ring == 0 ? 0U : static_cast<unsigned>(1 + 3 * ring * (ring - 1) + k % (6 * ring));
  };
  for (int ring = 1; ring <= rings; ++ring)
    for (int sixth = 0; sixth < 6; ++sixth)
      for (int k = 0; k < ring; ++k) {
        const unsigned inner = number(ring - 1, sixth * (ring - 1) + k);
        const unsigned here = number(ring, sixth * ring + k);
        const unsigned next = number(ring, sixth * ring + k + 1);
        mesh.indices.insert(mesh.indices.end(), {inner, here, next});
        if (k + 1 < ring)
          mesh.indices.insert(mesh.indices.end(),
                              {inner, next, number(ring - 1, sixth * (ring - 1) + k + 1)});
      }
  return mesh;
}

Mesh tubeMesh(float radius, float length, glm::ivec2 vertices) {
  Mesh mesh;
  const int columns = vertices.x - 1;
  for (int row = 0; row < vertices.y; ++row)
    for (int column = 0; column <= columns; ++column) {
      const double shift = row % 2 == 1 ? 0.5 : 0.0;
      const glm::dvec2 out = onCircle((column % columns + shift) / columns);
      const double v = static_cast<double>(row) / (vertices.y - 1);
      mesh.positions.emplace_back(radius * out.x, length * (0.5 - v), radius * out.y);
      mesh.normals.emplace_back(out.x, 0.0, out.y);
      mesh.uvs.emplace_back((column + shift) / columns, v);
    }
  for (int row = 0; row + 1 < vertices.y; ++row)
    for (int column = 0; column < columns; ++column) {
      const auto a = static_cast<unsigned>(row * (columns + 1) + column);
      const unsigned below = a + static_cast<unsigned>(columns) + 1;
      if (row % 2 == 0)
        mesh.indices.insert(mesh.indices.end(), {a, below, a + 1, a + 1, below, below + 1});
      else
        mesh.indices.insert(mesh.indices.end(), {a, below, below + 1, a, below + 1, a + 1});
    }
  return mesh;
}

Mesh cubedSphereMesh(float radius, int vertices) {
  Mesh mesh;
  // Side of a cube: its centre and the directions of u and v, where v points down as seen from outside.
  using Side = std::array<glm::dvec3, 3>;
  const Side sides[] = {
      {glm::dvec3(0, 0, 1), {1, 0, 0}, {0, -1, 0}},   {glm::dvec3(1, 0, 0), {0, 0, -1}, {0, -1, 0}},
      {glm::dvec3(0, 0, -1), {-1, 0, 0}, {0, -1, 0}}, {glm::dvec3(-1, 0, 0), {0, 0, 1}, {0, -1, 0}},
      {glm::dvec3(0, 1, 0), {1, 0, 0}, {0, 0, 1}},    {glm::dvec3(0, -1, 0), {1, 0, 0}, {0, 0, -1}}};
  for (const Side& side : sides) {
    const auto first = static_cast<unsigned>(mesh.positions.size());
    for (int y = 0; y < vertices; ++y)
      for (int x = 0; x < vertices; ++x) {
        const auto across = [&](int i) {  // The tangents of equally spaced angles give cells of similar
                                          // size. The mapping is odd, so the vertices of adjacent sides
                                          // coincide at their common edge.
          const int even = 2 * i - (vertices - 1);
          const double angle = 0.25 * std::numbers::pi * std::abs(even) / (vertices - 1);
          const double maximum = std::abs(even) == vertices - 1 ? 1.0 : ieee::tan(angle);
          return even < 0 ? -maximum : maximum;
        };
        const glm::dvec3 place = side[0] + side[1] * across(x) + side[2] * across(y);
        // The squares are summed in sorted order, so that vertices on two sides have identical bits.
        double squares[3] = {place.x * place.x, place.y * place.y, place.z * place.z};
        if (squares[0] > squares[1]) std::swap(squares[0], squares[1]);
        if (squares[1] > squares[2]) std::swap(squares[1], squares[2]);
        if (squares[0] > squares[1]) std::swap(squares[0], squares[1]);
        const glm::dvec3 normal = place / std::sqrt(squares[0] + squares[1] + squares[2]);
        mesh.positions.emplace_back(normal * static_cast<double>(radius));
        mesh.normals.emplace_back(normal);
        mesh.uvs.emplace_back(static_cast<double>(x) / (vertices - 1),
                              static_cast<double>(y) / (vertices - 1));
      }
    for (int y = 0; y + 1 < vertices; ++y)
      for (int x = 0; x + 1 < vertices; ++x) {
        const unsigned a = first + static_cast<unsigned>(y * vertices + x);
        const unsigned below = a + static_cast<unsigned>(vertices);
        // Splits the cell along its shorter diagonal, which points away from the centre of the side.
        if ((2 * x < vertices - 1) == (2 * y < vertices - 1))
          mesh.indices.insert(mesh.indices.end(), {a, below, below + 1, a, below + 1, a + 1});
        else
          mesh.indices.insert(mesh.indices.end(), {a, below, a + 1, a + 1, below, below + 1});
      }
  }
  return mesh;
}

}  // namespace simreel::sim
