#pragma once
#include "scene/scene.hpp"

#include <glm/vec3.hpp>

namespace simreel::draw {

/// Parameters of a skin, with the defaults of its look for the values that the scene leaves open.
struct SkinLook {
  const char* define;  ///< define of glsl/draw/surface/skin.glsl
  glm::vec3 low;       ///< colour of low field values, linear RGB
  glm::vec3 high;      ///< colour of high field values, linear RGB; for cracks a radiance, which may exceed
                       ///< 1
  float threshold;     ///< threshold as a fraction of the field's range
  float roughness;
  float depth;  ///< relief height of the whole value range, in cells, times the skin's bump; negative: high
                ///< values are low
};

[[nodiscard]] SkinLook lookOf(const scene::Skin& skin);

/// Returns the skin's threshold as a fraction of the range [first, last] of the field. If the range is
/// empty, 0 to 1 is used instead.
[[nodiscard]] float thresholdFraction(const scene::Skin& skin, glm::vec2 range);

}  // namespace simreel::draw
