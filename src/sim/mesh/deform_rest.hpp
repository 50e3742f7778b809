#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Rest mesh in the layout that the deformation reads, with the faces around each vertex.
struct RestMesh {
  /// Copies of a vertex that differ only in uv (seams, poles) share their faces, so that seams are
  /// invisible. Throws UserError(usage), naming `name`, if more than 20,000 triangles meet in a vertex.
  RestMesh(const std::string& name, const Mesh& mesh);

  std::vector<glm::vec4> positions;  ///< xyz position in m; w shortest edge at the vertex (m)
  std::vector<glm::vec4> normals;    ///< xyz unit normal
  std::vector<glm::uvec4> fans;      ///< per vertex: x first element in `faces`, y number of elements
  std::vector<glm::uvec4> faces;  ///< two faces per element: the other corners b, c and b', c'; a missing
                                  ///< second face repeats the vertex itself
};

}  // namespace simreel::sim
