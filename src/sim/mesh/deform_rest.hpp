#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// A mesh at rest as the deformation reads it, and the faces around each vertex.
struct RestMesh {
  /// Copies of a vertex that differ only in uv (seams, poles) share their faces, so no seam shows. Throws
  /// UserError(usage) when more than 20,000 triangles meet in a vertex; `name` stands in the message.
  RestMesh(const std::string& name, const Mesh& mesh);

  std::vector<glm::vec4> positions;  ///< xyz m; w shortest edge at the vertex (m)
  std::vector<glm::vec4> normals;    ///< xyz unit
  std::vector<glm::uvec4> fans;      ///< of a vertex: x first element of `faces`, y how many
  std::vector<glm::uvec4> faces;     ///< two faces (a, b, c) of a: b, c, b', c'; one missing has b = c = a
};

}  // namespace simreel::sim
