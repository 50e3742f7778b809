#pragma once
#include "scene/value/fields.hpp"
#include "sim/mesh/file/mesh_file.hpp"

#include <filesystem>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

enum class ClothShape { plane, disc, sphere, cylinder, torus, file };

/// The triangles that a cloth is made of, at rest.
struct ClothMesh {
  ClothShape shape = ClothShape::plane;
  std::filesystem::path file;
  glm::vec3 size{2, 0, 2};        ///< m, of a plane
  float radius = 1.0F;            ///< m
  float tube = 0.35F;             ///< m
  float length = 2.0F;            ///< m, of a cylinder
  glm::ivec2 resolution{33, 33};  ///< vertices along u and v
  float scale = 1.0F;
  float weld = 0.0F;  ///< m
  void describe(scene::Fields& fields);
  /// Generates or reads the mesh. Throws what loadMesh throws.
  [[nodiscard]] Mesh make() const;
  /// What messages call it.
  [[nodiscard]] std::string text() const;
};

/// A round sheet in the xz plane, facing +y: `rings` of equally wide rings around its middle, the k-th of 6
/// k vertices; uv = the place in its square.
[[nodiscard]] Mesh discMesh(float radius, int rings);

/// An open tube around y of `vertices` around it (the seam once more) and along it, rows in turn shifted by
/// half a cell, so that faces are close to equilateral where their number fits. Facing outwards.
[[nodiscard]] Mesh tubeMesh(float radius, float length, glm::ivec2 vertices);

/// A ball of six grids of `vertices` a side, uv of each over the whole picture: no poles, at which faces
/// would be slivers.
[[nodiscard]] Mesh cubedSphereMesh(float radius, int vertices);

}  // namespace simreel::sim
