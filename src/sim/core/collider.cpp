#include "sim/core/collider.hpp"

#include "sim/core/shader_code.hpp"

namespace simreel::sim {

glm::mat4 rotationMatrix(const glm::vec3& degrees) {
  const glm::vec3 angle = degrees * 0.017453293F;
  const float cx = shader::exactCos(angle.x);
  const float sx = shader::exactSin(angle.x);
  const float cy = shader::exactCos(angle.y);
  const float sy = shader::exactSin(angle.y);
  const float cz = shader::exactCos(angle.z);
  const float sz = shader::exactSin(angle.z);
  // Columns of Rz Ry Rx.
  return {glm::vec4(cz * cy, sz * cy, -sy, 0),
          glm::vec4(cz * sy * sx - sz * cx, sz * sy * sx + cz * cx, cy * sx, 0),
          glm::vec4(cz * sy * cx + sz * sx, sz * sy * cx - cz * sx, cy * cx, 0), glm::vec4(0, 0, 0, 1)};
}

}  // namespace simreel::sim
