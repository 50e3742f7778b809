#pragma once
#include "glsl/common/cpp.hpp"

#include <cstddef>
#include <vector>

namespace held_twin {
using namespace simreel::shader;
#define FUNCTION inline
#define precise
#include "glsl/cloth/held.glsl"
#undef precise
#undef FUNCTION
}  // namespace held_twin

/// CPU version of glsl/cloth/hold.comp. Sets the velocities of particles that are pinned to a skin. `ways`:
/// displacements of the pins in the frame.
inline void holdBySkin(const std::vector<glm::vec4>& ways, int substep, int substeps,
                       std::vector<glm::vec4>& velocities) {
  const double now = static_cast<double>(substep + 1) / substeps;
  for (std::size_t k = 0; k + 1 < ways.size(); k += 2)
    velocities[static_cast<std::size_t>(ways[k].w)] =
        glm::vec4(held_twin::heldBetween(glm::vec3(ways[k]), glm::vec3(ways[k + 1]),
                                         static_cast<float>(1.0 - now), static_cast<float>(now)),
                  -1.0F);
}
