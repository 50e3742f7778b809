#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// Content of a Wavefront OBJ file.
struct ObjFile {
  /// Indices into the lists below, or -1 for none.
  struct Corner {
    int place, uv, normal;
  };
  struct Face {
    std::size_t first;  ///< index of the face's first corner
    unsigned count;
    int material;     ///< index into the list of material names, or -1 for none
    unsigned smooth;  ///< smoothing group; 0 for none, in which case the face is flat
  };
  std::vector<glm::vec3> places, normals;
  std::vector<glm::vec3> colors;  ///< one colour per position; empty if no position has a colour
  std::vector<glm::vec2> uvs;
  std::vector<Corner> corners;
  std::vector<Face> faces;
  std::vector<std::string> materials;  ///< names of materials given by usemtl, in the order of their first
                                       ///< use
  std::vector<std::string> libraries;  ///< text after the keyword of each mtllib line
  std::vector<std::string> notDrawn;   ///< content that is not drawn, for example "lines (3)"
};

/// Parses the text of an OBJ file (Wavefront, Appendix B1 of the Advanced Visualizer's manual). Comments
/// begin with '#', also after values; a backslash at the end of a line continues the line. Vertex weights w
/// are ignored, because they apply only to curves. Throws PolygonProblem, naming the line, for malformed or
/// non-finite numbers, missing vertices, faces with more than maxCorners corners, and more than `maximum`
/// vertices or faces.
[[nodiscard]] ObjFile parseObj(std::string_view text, std::size_t maximum);

}  // namespace simreel::sim
