#pragma once
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

struct SolidShape;

/// Constant part of a solid, independent of its field: sides and bottom, and the roof if there is a
/// ceiling. Its vertices follow the samples' vertices.
struct SolidBorder {
  std::vector<glm::vec4> positions;  ///< Vertex positions in xyz, colour index in w.
  std::vector<glm::vec4> normals;
  std::vector<unsigned> indices;  ///< Triangle indices; their number is even.
};
/// Builds the border. `heights`: height of each class; `firstVertex`: index of the border's first vertex.
[[nodiscard]] SolidBorder solidBorder(const SolidShape& shape, const std::vector<float>& heights,
                                      unsigned firstVertex);

/// Returns x and z (metres) of sample (0, 0), one sample before the field's first cell.
[[nodiscard]] glm::vec2 solidCorner(const SolidShape& shape);

}  // namespace simreel::sim
