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

/// Order of the scene's lights in shaders, where lamps with shadows come first, and layout of their shadow
/// maps in one atlas: a row of six maps per lamp, with the rows stacked.
struct LampOrder {
  explicit LampOrder(const scene::Scene& scene);
  std::vector<const scene::Light*> lights;
  int shadowed = 0;
  int ranged = 0;          ///< number of lamps without shadow that have a range; they come last
  std::vector<int> rows;   ///< for each lamp with shadows, texels below its row
  glm::ivec2 atlas{0, 0};  ///< size of the atlas (texels); zero without shadows
};

/// Returns all lamps at `seconds` of scene time. Light is in the units of glsl/draw/frame.glsl: irradiance
/// / pi, where a sun of intensity 1 gives 1 lux, like a lamp of 1 cd at 1 m. Lamps on a path take their
/// position from `drawables`; they have no power if the path is missing.
[[nodiscard]] std::vector<shader::Lamp> lampValues(const LampOrder& order, int seed, double seconds,
                                                   const sim::Drawables& drawables);

/// Returns the luminous intensity (cd) of a light at `seconds`, in the centre of its cone if it has one,
/// converted from its unit.
[[nodiscard]] float candelas(const scene::Light& light, double seconds);

/// Returns the bits that tell which of the last `ranged` lamps reach which cell of the box around their
/// ranges, in the layout of lampCells in glsl/draw/lights/lamps.glsl.
[[nodiscard]] std::vector<std::uint32_t> lampCells(const std::vector<shader::Lamp>& lamps, int ranged);

/// Stores the positions of the maps in whole texels in `maps`, as glsl/draw/exact/shadows/lamp_maps.glsl
/// reads them.
void setTexels(std::vector<shader::Lamp>& lamps, const LampOrder& order);

}  // namespace simreel::draw
