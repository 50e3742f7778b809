#pragma once
#include "scene/scene.hpp"

#include <glm/vec3.hpp>

namespace simreel::draw {

/// Parameters of a skin. Values that the scene does not set have the defaults of the skin's look.
struct SkinLook {
  const char* define;  ///< define of glsl/draw/surface/skin.glsl
  glm::vec3 low;       ///< colour of low field values, linear RGB
  glm::vec3 high;      ///< colour of high field values, linear RGB; for cracks a radiance, which may exceed
                       ///< 1
  float threshold;     ///< threshold as a fraction of the field's range
  float roughness;
  float depth;  ///< relief height of the field's full value range, in cells, including the factor `bump` of
                ///< the skin; if negative, high values are low
};

[[nodiscard]] SkinLook lookOf(const scene::Skin& skin);

/// Returns the skin's threshold as a fraction of the field's range [first, last]. An empty range counts as
/// 0 to 1.
[[nodiscard]] float thresholdFraction(const scene::Skin& skin, glm::vec2 range);

}  // namespace simreel::draw
