#pragma once
#include "scene/value/fields.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <filesystem>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

enum class ClothShape { plane, disc, sphere, cylinder, torus, file };

/// Source of a cloth's rest mesh: a generated shape or a file.
struct ClothMesh {
  ClothShape shape = ClothShape::plane;
  std::filesystem::path file;
  glm::vec3 size{2, 0, 2};        ///< width and depth of a plane in metres
  float radius = 1.0F;            ///< radius in metres
  float tube = 0.35F;             ///< radius of the tube of a torus in metres
  float length = 2.0F;            ///< length of a cylinder in metres
  glm::ivec2 resolution{33, 33};  ///< number of vertices along u and v
  float scale = 1.0F;
  float weld = 0.0F;  ///< distance in metres within which vertices are merged
  void describe(scene::Fields& fields);
  /// Generates the mesh or reads it from the file. Throws the errors of loadMesh().
  [[nodiscard]] Mesh make() const;
  /// Returns a short name for messages: the shape or the file.
  [[nodiscard]] std::string text() const;
};

/// Returns a round sheet in the xz plane that faces +y: a centre and `rings` rings of equal width, the k-th
/// with 6 k vertices. uv is the position in the bounding square.
[[nodiscard]] Mesh discMesh(float radius, int rings);

/// Returns an open tube around the y axis whose faces point outwards. It has `vertices.x` vertices around
/// the axis, counting the seam twice, and `vertices.y` along it. Every second row is shifted by half a
/// cell, which makes the faces nearly equilateral if the vertex counts suit the tube's proportions.
[[nodiscard]] Mesh tubeMesh(float radius, float length, glm::ivec2 vertices);

/// Returns a sphere made of six grids with `vertices` vertices per side. The uv of each grid cover the
/// whole unit square. Unlike a latitude-longitude sphere, it has no poles with sliver faces.
[[nodiscard]] Mesh cubedSphereMesh(float radius, int vertices);

}  // namespace simreel::sim
