#pragma once
#include "scene/scene.hpp"

#include <glm/vec3.hpp>

namespace simreel::draw {

/// What a skin comes to when the scene leaves the choice to its look.
struct SkinLook {
  const char* define;  ///< of glsl/draw/surface/skin.glsl
  glm::vec3 low;       ///< linear RGB
  glm::vec3 high;      ///< linear RGB; of cracks radiance, of which there may be more than 1
  float threshold;     ///< fraction of the field's range
  float roughness;
  float
      depth;  ///< height of the whole range in cells, times the skin's bump; negative: high values lie low
};

[[nodiscard]] SkinLook lookOf(const scene::Skin& skin);

/// The skin's threshold as a fraction of the field's range [first, last]; of an empty range, 0 to 1.
[[nodiscard]] float thresholdFraction(const scene::Skin& skin, glm::vec2 range);

}  // namespace simreel::draw
