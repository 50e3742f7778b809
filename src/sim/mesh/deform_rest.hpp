#pragma once
#include "sim/mesh/file/mesh_file.hpp"

#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace simreel::sim {

/// Undeformed mesh in the layout that the deformation reads, with the faces around each vertex.
struct RestMesh {
  /// Copies of a vertex that differ only in uv (at seams and poles) use the same faces for their normals,
  /// so that seams are invisible. Throws UserError(usage), naming `name`, if more than 20,000 triangles
  /// meet in a vertex.
  RestMesh(const std::string& name, const Mesh& mesh);

  std::vector<glm::vec4> positions;  ///< xyz: position in metres; w: length in metres of the shortest edge
                                     ///< at the vertex
  std::vector<glm::vec4> normals;    ///< xyz: unit normal
  std::vector<glm::uvec4> fans;      ///< for each vertex: x is the index of its first element in `faces`, y
                                     ///< its number of elements
  std::vector<glm::uvec4> faces;  ///< two faces per element: the corners b, c of the first face and b', c'
                                  ///< of the second face, other than the vertex itself; if there is no
                                  ///< second face, b' and c' are the vertex itself
};

}  // namespace simreel::sim
