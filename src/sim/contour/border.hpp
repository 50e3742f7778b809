#pragma once
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

struct SolidShape;

/// Part of a solid that does not depend on its field: sides and bottom, and the roof if there is a ceiling.
/// In the vertex buffer, its vertices follow the samples.
struct SolidBorder {
  std::vector<glm::vec4> positions;  ///< Vertex positions in xyz, colour index in w.
  std::vector<glm::vec4> normals;
  std::vector<unsigned> indices;  ///< Triangle indices; their number is even.
};
/// Builds the border. `heights` are the heights of the classes; `firstVertex` is the index of the border's
/// first vertex.
[[nodiscard]] SolidBorder solidBorder(const SolidShape& shape, const std::vector<float>& heights,
                                      unsigned firstVertex);

/// Returns x and z (metres) of sample (0, 0), which is one sample before the field's first cell.
[[nodiscard]] glm::vec2 solidCorner(const SolidShape& shape);

}  // namespace simreel::sim
