#include "sim/mesh/shapes.hpp"

#include "base/ieee.hpp"
#include "sim/core/shader_code.hpp"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

constexpr double fullTurn = 2.0 * std::numbers::pi;

void reserve(Mesh& mesh, unsigned rows, unsigned columns) {
  const std::size_t vertices = (std::size_t{rows} + 1) * (columns + 1);
  mesh.positions.reserve(vertices);
  mesh.normals.reserve(vertices);
  mesh.uvs.reserve(vertices);
  mesh.indices.reserve(std::size_t{6} * rows * columns);
}

/// Adds quads between rows + 1 rows of columns + 1 vertices. The quads face the side from which u increases
/// to the right and v increases downwards.
void connectRows(Mesh& mesh, unsigned rows, unsigned columns) {
  for (unsigned row = 0; row < rows; ++row)
    for (unsigned column = 0; column < columns; ++column) {
      const unsigned a = row * (columns + 1) + column;
      const unsigned b = a + columns + 1;
      mesh.indices.insert(mesh.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
    }
}

/// Returns a sphere as rings of latitude. If length > 0, the equator exists twice, with the copies `length`
/// apart, and `rows` must be even.
Mesh roundMesh(float radius, float length, unsigned rows, unsigned columns) {
  const bool parted = length > 0;
  const unsigned rings = rows + 1 + (parted ? 1 : 0);
  Mesh mesh;
  reserve(mesh, rings - 1, columns);
  for (unsigned ring = 0; ring < rings; ++ring) {
    const bool lower = ring > rows / 2;
    const unsigned step = parted && lower ? ring - 1 : ring;
    const double polar = std::numbers::pi * step / rows;
    const double across = step == rows ? 0.0 : ieee::sin(polar);  // exactly 0, so that all vertices of a
                                                                  // pole coincide
    for (unsigned column = 0; column <= columns; ++column) {
      const double angle = fullTurn * (column % columns) / columns;
      const glm::vec3 normal(static_cast<float>(across * ieee::sin(angle)),
                             static_cast<float>(ieee::cos(polar)),
                             static_cast<float>(across * ieee::cos(angle)));
      glm::vec3 position = normal * radius;
      position.y += lower ? -0.5F * length : 0.5F * length;
      mesh.positions.push_back(position);
      mesh.normals.push_back(normal);
      mesh.uvs.emplace_back(static_cast<float>(column) / static_cast<float>(columns),
                            static_cast<float>(step) / static_cast<float>(rows));
    }
  }
  connectRows(mesh, rings - 1, columns);
  return mesh;
}

constexpr unsigned roundColumns = 64;

/// Returns the horizontal unit vector of a column. Column 0 and the last column are the two sides of the
/// seam, so their vectors are equal.
glm::vec3 outwards(unsigned column) {
  const double angle = fullTurn * (column % roundColumns) / roundColumns;
  return {static_cast<float>(ieee::sin(angle)), 0, static_cast<float>(ieee::cos(angle))};
}

/// Adds a disc around the y axis at height y. It faces up if `side` is +1, down if `side` is -1.
void addDisc(Mesh& mesh, float radius, float y, float side) {
  const auto middle = static_cast<unsigned>(mesh.positions.size());
  const auto add = [&](const glm::vec3& at) {
    mesh.positions.push_back(at * radius + glm::vec3(0, y, 0));
    mesh.normals.emplace_back(0, side, 0);
    mesh.uvs.emplace_back(0.5F + 0.5F * at.x, 0.5F + 0.5F * side * at.z);
  };
  add(glm::vec3(0));
  for (unsigned column = 0; column < roundColumns; ++column) add(outwards(column));
  for (unsigned column = 0; column < roundColumns; ++column) {
    const unsigned a = middle + 1 + column, b = middle + 1 + (column + 1) % roundColumns;
    mesh.indices.insert(mesh.indices.end(), {middle, side > 0 ? a : b, side > 0 ? b : a});
  }
}

}  // namespace

Mesh planeMesh(const glm::vec3& size, glm::ivec2 vertices) {
  const auto columns = static_cast<unsigned>(vertices.x - 1);
  const auto rows = static_cast<unsigned>(vertices.y - 1);
  Mesh mesh;
  reserve(mesh, rows, columns);
  for (unsigned row = 0; row <= rows; ++row)
    for (unsigned column = 0; column <= columns; ++column) {
      const glm::vec2 uv(static_cast<float>(column) / static_cast<float>(columns),
                         static_cast<float>(row) / static_cast<float>(rows));
      mesh.positions.emplace_back((uv.x - 0.5F) * size.x, 0.0F, (uv.y - 0.5F) * size.z);
      mesh.normals.emplace_back(0, 1, 0);
      mesh.uvs.push_back(uv);
    }
  connectRows(mesh, rows, columns);
  return mesh;
}

Mesh sphereMesh(float radius, glm::ivec2 vertices) {
  return roundMesh(radius, 0.0F, static_cast<unsigned>(vertices.y - 1),
                   static_cast<unsigned>(vertices.x - 1));
}

// Each edge is interpolated from its corner with the lower index to the other corner, so that both faces at
// the edge compute positions with identical bits.
Mesh geodesicMesh(float radius, int parts) {
  const double golden = (1 + std::sqrt(5.0)) / 2;
  std::vector<glm::dvec3> corners;
  for (const double one : {-1.0, 1.0})
    for (const double other : {-golden, golden})
      corners.insert(corners.end(), {{0, one, other}, {one, other, 0}, {other, 0, one}});
  const auto near = [&](std::size_t a, std::size_t b) {
    return glm::distance(corners[a], corners[b]) < 2.5;  // The distance between neighbouring corners is 2;
                                                         // the distance between other corners is more than
                                                         // 3.
  };
  Mesh mesh;
  const auto face = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const bool outwards = glm::dot(glm::cross(b - a, c - a), a) > 0;
    unsigned row = static_cast<unsigned>(mesh.positions.size());
    for (int k = 0; k <= parts; ++k) {
      const auto length = static_cast<unsigned>(parts - k);
      for (int j = 0; j <= parts - k; ++j)
        mesh.normals.emplace_back(
            glm::normalize(a * double(parts - j - k) + b * double(j) + c * double(k)));
      for (unsigned j = 0; j < length; ++j) {
        const unsigned at = row + j, above = at + length + 1;
        const auto triangle = [&](unsigned x, unsigned y, unsigned z) {
          mesh.indices.insert(mesh.indices.end(), {x, outwards ? y : z, outwards ? z : y});
        };
        triangle(at, at + 1, above);
        if (j + 1 < length) triangle(at + 1, above + 1, above);
      }
      row += length + 1;
    }
    mesh.positions.resize(mesh.normals.size());
  };
  for (std::size_t a = 0; a < corners.size(); ++a)
    for (std::size_t b = a + 1; b < corners.size(); ++b)
      for (std::size_t c = b + 1; c < corners.size(); ++c)
        if (near(a, b) && near(b, c) && near(a, c)) face(corners[a], corners[b], corners[c]);
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) mesh.positions[i] = mesh.normals[i] * radius;
  return mesh;
}

Mesh capsuleMesh(float radius, float length) {
  return roundMesh(radius, length, 32, 64);
}

Mesh torusMesh(float radius, float tube, glm::ivec2 vertices) {
  const auto columns = static_cast<unsigned>(vertices.x - 1);
  const auto rows = static_cast<unsigned>(vertices.y - 1);
  Mesh mesh;
  reserve(mesh, rows, columns);
  for (unsigned row = 0; row <= rows; ++row) {
    // The rows start at the outer rim and cross the underside first, so that they run down on the outside.
    const double around = -fullTurn * (row % rows) / rows;
    const double reach = radius + tube * ieee::cos(around);
    for (unsigned column = 0; column <= columns; ++column) {
      const double along = fullTurn * (column % columns) / columns;
      const double x = ieee::sin(along);
      const double z = ieee::cos(along);
      mesh.positions.emplace_back(static_cast<float>(reach * x),
                                  static_cast<float>(tube * ieee::sin(around)),
                                  static_cast<float>(reach * z));
      mesh.normals.emplace_back(static_cast<float>(ieee::cos(around) * x),
                                static_cast<float>(ieee::sin(around)),
                                static_cast<float>(ieee::cos(around) * z));
      mesh.uvs.emplace_back(static_cast<float>(column) / static_cast<float>(columns),
                            static_cast<float>(row) / static_cast<float>(rows));
    }
  }
  connectRows(mesh, rows, columns);
  return mesh;
}

Mesh boxMesh(const glm::vec3& size) {
  Mesh mesh;
  const auto face = [&](const glm::vec3& normal, const glm::vec3& right, const glm::vec3& down) {
    const auto first = static_cast<unsigned>(mesh.positions.size());
    for (const float v : {0.0F, 1.0F})
      for (const float u : {0.0F, 1.0F}) {
        mesh.positions.push_back(0.5F * size * (normal + (2 * u - 1) * right + (2 * v - 1) * down));
        mesh.normals.push_back(normal);
        mesh.uvs.emplace_back(u, v);
      }
    mesh.indices.insert(mesh.indices.end(), {first, first + 2, first + 1, first + 1, first + 2, first + 3});
  };
  for (const float side : {1.0F, -1.0F}) {
    face({0, 0, side}, {side, 0, 0}, {0, -1, 0});
    face({side, 0, 0}, {0, 0, -side}, {0, -1, 0});
    face({0, side, 0}, {1, 0, 0}, {0, 0, side});
  }
  return mesh;
}

Mesh cylinderMesh(float topRadius, float bottomRadius, float height) {
  Mesh mesh;
  const glm::vec2 slope = glm::normalize(glm::vec2(height, bottomRadius - topRadius));
  for (const bool bottom : {false, true})
    for (unsigned column = 0; column <= roundColumns; ++column) {
      const glm::vec3 out = outwards(column);
      mesh.positions.push_back((bottom ? bottomRadius : topRadius) * out +
                               glm::vec3(0, (bottom ? -0.5F : 0.5F) * height, 0));
      mesh.normals.push_back(slope.x * out + glm::vec3(0, slope.y, 0));
      mesh.uvs.emplace_back(static_cast<float>(column) / roundColumns, bottom ? 1.0F : 0.0F);
    }
  connectRows(mesh, 1, roundColumns);
  if (topRadius > 0) addDisc(mesh, topRadius, 0.5F * height, 1);
  addDisc(mesh, bottomRadius, -0.5F * height, -1);
  return mesh;
}

Mesh discMesh(float radius) {
  Mesh mesh;
  addDisc(mesh, radius, 0, 1);
  return mesh;
}

Mesh grassMesh(const glm::vec3& size, int blades, float height, float width, int seed) {
  constexpr unsigned segments = 4;
  Mesh mesh;
  for (int blade = 0; blade < blades; ++blade) {
    const auto number = static_cast<unsigned>(blade);
    const auto bits = shader::hash3({number, 1U, static_cast<unsigned>(seed)});
    const auto more = shader::hash3({number, 2U, static_cast<unsigned>(seed)});
    const glm::vec3 root(0.5F * size.x * shader::signedUnit(bits.x), 0,
                         0.5F * size.z * shader::signedUnit(bits.y));
    const float angle = 3.14159265F * shader::signedUnit(bits.z);
    const glm::vec3 across(shader::exactCos(angle), 0, shader::exactSin(angle));
    const glm::vec3 out(-across.z, 0, across.x);  // direction in which the blade bends
    const float tall = height * (0.75F + 0.25F * shader::signedUnit(more.x));
    const float bend = tall * (0.3F + 0.2F * shader::signedUnit(more.y));
    const float hue = 0.5F + 0.49F * shader::signedUnit(more.z);
    const auto first = static_cast<unsigned>(mesh.positions.size());
    for (unsigned step = 0; step <= segments; ++step) {
      const float s = static_cast<float>(step) / segments;
      const glm::vec3 middle = root + out * (bend * s * s) + glm::vec3(0, tall * s * (1 - 0.15F * s), 0);
      const glm::vec3 rise = out * (2 * bend * s) + glm::vec3(0, tall * (1 - 0.3F * s), 0);
      const glm::vec3 normal = glm::normalize(glm::cross(rise, across));
      const float half = 0.5F * width * (1 - 0.75F * s * s);
      for (const float side : {-1.0F, 1.0F}) {
        mesh.positions.push_back(middle + across * (side * half));
        mesh.normals.push_back(normal);
        mesh.uvs.emplace_back(hue + 0.004F * side, 1 - s);
      }
      const unsigned a = first + 2 * step;
      if (step < segments) mesh.indices.insert(mesh.indices.end(), {a, a + 2, a + 1, a + 1, a + 2, a + 3});
    }
  }
  return mesh;
}

}  // namespace simreel::sim
