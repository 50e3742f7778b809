#pragma once
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

struct SolidShape;

/// What of a solid stays the same whatever its field: the sides and the bottom, of one with a ceiling the
/// roof too. Its vertices come after those of the samples.
struct SolidBorder {
  std::vector<glm::vec4> positions;  ///< w: number of the colour
  std::vector<glm::vec4> normals;
  std::vector<unsigned> indices;  ///< an even number
};
/// `heights`: of the classes; `firstVertex`: number of its first vertex.
[[nodiscard]] SolidBorder solidBorder(const SolidShape& shape, const std::vector<float>& heights,
                                      unsigned firstVertex);

/// x and z (m) of sample (0, 0), which lies one before the field's first cell.
[[nodiscard]] glm::vec2 solidCorner(const SolidShape& shape);

}  // namespace simreel::sim
