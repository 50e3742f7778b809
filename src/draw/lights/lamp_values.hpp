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

/// Order of the scene's lights in shaders and layout of their shadow maps. Lamps with shadows come first.
/// The atlas has one row of six maps per lamp; the rows are stacked.
struct LampOrder {
  explicit LampOrder(const scene::Scene& scene);
  std::vector<const scene::Light*> lights;
  int shadowed = 0;
  int ranged = 0;          ///< number of lamps that have a range and no shadow; they come last
  std::vector<int> rows;   ///< for each lamp with shadows, the offset of its row in the atlas (texels)
  glm::ivec2 atlas{0, 0};  ///< size of the atlas (texels); zero if no lamp casts shadows
};

/// Returns all lamps at `seconds` of scene time. Light is in the units of glsl/draw/frame.glsl: irradiance
/// / pi. In these units a sun of intensity 1 gives as much light as 1 lux, or as a lamp of 1 cd at 1 m. A
/// lamp on a path takes its position from `drawables`, and has no power if the path is missing.
[[nodiscard]] std::vector<shader::Lamp> lampValues(const LampOrder& order, int seed, double seconds,
                                                   const sim::Drawables& drawables);

/// Returns the luminous intensity (cd) of a light at `seconds`, converted from the light's unit. For a
/// spotlight, this is the intensity in the centre of the cone.
[[nodiscard]] float candelas(const scene::Light& light, double seconds);

/// Divides the box around the ranges of the last `ranged` lamps into cells. Returns bits that say which
/// lamps light which cell, in the layout of lampCells in glsl/draw/lights/lamps.glsl.
[[nodiscard]] std::vector<std::uint32_t> lampCells(const std::vector<shader::Lamp>& lamps, int ranged);

/// Writes the positions of the maps in whole texels to `maps`, as glsl/draw/exact/shadows/lamp_maps.glsl
/// reads them.
void setTexels(std::vector<shader::Lamp>& lamps, const LampOrder& order);

}  // namespace simreel::draw
