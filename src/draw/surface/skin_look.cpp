#include "draw/surface/skin_look.hpp"

#include <cstddef>

#include <glm/vec2.hpp>

namespace simreel::draw {

namespace {

glm::vec3 orOwn(const glm::vec3& given, const glm::vec3& own) {
  return given.x < 0 || given.y < 0 || given.z < 0 ? own : given;
}

}  // namespace

SkinLook lookOf(const scene::Skin& skin) {
  // Defaults of the looks, in the order of scene::Skin::Look. The dark lines of leather are creases. Cracks
  // are deep and glow.
  static constexpr SkinLook looks[] = {
      {"LOOK_LEATHER", {0.3F, 0.15F, 0.05F}, {0.1F, 0.05F, 0.02F}, 0.5F, 0.7F, -3.0F},
      {"LOOK_SPOTS", {0.62F, 0.33F, 0.10F}, {0.035F, 0.018F, 0.008F}, 0.5F, 0.75F, 0.8F},
      {"LOOK_CRACKS", {0.045F, 0.038F, 0.036F}, {9.0F, 1.7F, 0.18F}, 0.5F, 0.85F, -5.0F},
      {"LOOK_MAP", glm::vec3(0), glm::vec3(0), 0.5F, 0.5F, 2.0F}};
  SkinLook look = looks[static_cast<std::size_t>(skin.look)];
  look.low = orOwn(skin.low, look.low);
  look.high = orOwn(skin.high, look.high);
  if (skin.roughness) look.roughness = static_cast<float>(*skin.roughness);
  look.depth *= skin.bump;
  return look;
}

float thresholdFraction(const scene::Skin& skin, glm::vec2 range) {
  if (!skin.threshold) return lookOf(skin).threshold;
  const float span = range.y == range.x ? 1.0F : range.y - range.x;
  return (static_cast<float>(*skin.threshold) - range.x) / span;
}

}  // namespace simreel::draw
