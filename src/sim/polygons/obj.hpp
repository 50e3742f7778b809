#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

/// The faces of a Wavefront OBJ, as the file has them.
struct ObjFile {
  /// Numbers into the lists below; -1: none.
  struct Corner {
    int place, uv, normal;
  };
  struct Face {
    std::size_t first;  ///< of its corners
    unsigned count;
    int material;     ///< number into the list of names; -1: none
    unsigned smooth;  ///< its smoothing group; 0: none, so it is flat
  };
  std::vector<glm::vec3> places, normals;
  std::vector<glm::vec3> colors;  ///< of each place, as the file has them; empty where no place has one
  std::vector<glm::vec2> uvs;
  std::vector<Corner> corners;
  std::vector<Face> faces;
  std::vector<std::string> materials;  ///< named by usemtl, in the order of their first use
  std::vector<std::string> libraries;  ///< the rest of each mtllib line
  std::vector<std::string> notDrawn;   ///< such as "lines (3)"
};

/// Reads the text of an OBJ (Wavefront, Appendix B1 of the Advanced Visualizer's manual). Comments begin
/// with '#', also behind values; a line that ends with a backslash goes on in the next. Weights w of
/// vertices are of curves and change no face. Throws PolygonProblem, naming the line: for what is no number
/// or no finite one, vertices that are not there, more than maxCorners of a face and more than `most`
/// vertices or faces.
[[nodiscard]] ObjFile parseObj(std::string_view text, std::size_t most);

}  // namespace simreel::sim
