#pragma once
#include "glsl/common/cpp.hpp"
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::shader {

#include "glsl/draw/lights/types.glsl"

}  // namespace simreel::shader

namespace simreel::draw {

/// The scene's lights in the order in which shaders know them as lamps: those with shadows first, and how
/// their shadow maps lie in one texture: a row of six for each, rows on top of each other.
struct LampOrder {
  explicit LampOrder(const scene::Scene& scene);
  std::vector<const scene::Light*> lights;
  int shadowed = 0;
  int ranged = 0;          ///< those without shadow that have a range: the last ones
  std::vector<int> rows;   ///< texels below the row of each that has shadows
  glm::ivec2 atlas{0, 0};  ///< texels; zero without shadows
};

/// All lamps at `seconds` of scene time. Light is in the units of glsl/draw/frame.glsl: irradiance / pi,
/// where a sun of intensity 1 gives 1 lux, as a lamp of 1 cd does at 1 m. Those that follow a path stand by
/// that of the drawables, and have no power without.
[[nodiscard]] std::vector<shader::Lamp> lampValues(const LampOrder& order, int seed, double seconds,
                                                   const sim::Drawables& drawables);

/// Luminous intensity (cd) of a light at that time, in the middle of its cone if it has one, whatever its
/// unit.
[[nodiscard]] float candelas(const scene::Light& light, double seconds);

/// Words that say which of the last `ranged` lamps reach into which cell of the box around what they reach,
/// as lampCells of glsl/draw/lights/lamps.glsl.
[[nodiscard]] std::vector<std::uint32_t> lampCells(const std::vector<shader::Lamp>& lamps, int ranged);

/// Says in `maps` where the maps lie in whole texels, as glsl/draw/exact/shadows/lamp_maps.glsl reads it.
void setTexels(std::vector<shader::Lamp>& lamps, const LampOrder& order);

}  // namespace simreel::draw
