#pragma once
#include "draw/exact/visibility.hpp"
#include "gl/kernel/kernel.hpp"
#include "scene/scene.hpp"

#include <glm/vec2.hpp>

// Common parts of the kernels that shade the tiles of a picture.
namespace simreel::draw {

/// Values of `layer` that select texture coordinates and the colours of an overlay, as SHOWN in
/// glsl/draw/surface/overlay.glsl.
inline constexpr int shownUv = 3;
[[nodiscard]] constexpr int shownOverlay(scene::Overlay overlay) {
  return shownUv + static_cast<int>(overlay);
}
/// Value of `layer` that selects the change of light by screen-space reflections.
inline constexpr int shownReflections = -1;

/// Uniforms, buffers and textures that draw/exact/tiles/shaded_tile.glsl declares.
struct TileFields {
  gl::Ambient<"FrameBlock"> frame;
  gl::Ambient<"ViewBlock"> view;
  SamplesRead samples;
  gl::In<"tileLists"> lists;
  gl::In<"tileCounts"> counts;
  gl::Uniform<"draw_", int> thing;
  gl::Uniform<"tileCount", int> tileCount;
};

/// Shader inputs of draw/surface/lighting.glsl and the files that it includes: lights, shadows, occlusion,
/// and the sums that receive the light. The lamps, the transform of the sun's shadow map and the
/// environment are bound beforehand.
struct SceneLight {
  gl::Ambient<"environment"> environment;
  gl::Ambient<"LampBlock"> lampBlock;
  gl::Ambient<"lampMembers"> lamps;
  gl::Ambient<"lampCells"> lampCells;
  gl::Ambient<"lampShadows"> lampShadows;
  gl::Ambient<"light"> sunPlace;
  gl::In<"lampKeys"> lampKeys;
  gl::In<"sunMap"> sunMap;
  gl::In<"openness"> openness;
  gl::In<"nearestLevels"> nearestLevels;  ///< mip pyramid of nearness, which reflections read
  gl::In<"litLevels"> litLevels;
  gl::Uniform<"mirrorReach", glm::vec2> mirrorReach;  ///< max length of reflected rays, and assumed
                                                      ///< thickness of reflected objects (m)
  gl::In<"litPixels"> litPixels = {};                 ///< light of each pixel without reflections
  gl::In<"unevenTiles"> unevenTiles = {};    ///< blocks of 2x2 pixels whose pixels are traced one by one
  gl::Uniform<"refined", int> refined = {};  ///< 1 to trace each pixel of the uneven blocks; 0 to trace
                                             ///< once per block
  gl::In<"layersLeave"> layersLeave;  ///< fraction of light that the blended layers in front let through,
                                      ///< per sample
  gl::InOut<"ThroughBlock"> through;  ///< fraction of light that the blended layers shaded so far let
                                      ///< through, per sample; shading a layer updates it
  gl::Shared<"SpotBlock"> spots;      ///< visible surface points that rays light later
  gl::InOut<"sums"> sums;             ///< summed light of each pixel
  gl::Uniform<"linear", int> linear;  ///< 1 to average the samples of a pixel without compressed
                                      ///< brightness (glsl/draw/exact/screen/edge_light.glsl)
};

struct ShadeVariant {
  SampleVariant samples;
  gl::Flag<"PARALLEL"> parallel;
  gl::Flag<"FAST_NUMERICS"> fast;
  gl::Range<"ROWS", 1, 8> rows;
  gl::Flag<"OCCLUSION"> occlusion;
  gl::Flag<"BEHIND"> behind;  ///< blended layers may be in front of the object
  gl::Flag<"RAYS"> rays;
  gl::Flag<"GROUND_REFLECTIVE"> groundReflective;
  gl::Flag<"REFLECTED"> reflected;
  gl::Range<"SHOWN", 1, 8> shown;
  gl::Range<"HAZE", 1, 2> haze;  ///< value of HAZE in glsl/draw/exact/haze.glsl; none without haze
};
/// Defines for objects other than the ground. Smooth objects may reflect the ground below them
/// (GROUND_BELOW).
struct ThingVariant {
  ShadeVariant shade;
  gl::Flag<"GROUND_BELOW"> stageGroundHeight;
};

/// Returns the variant of a kernel that computes `layer`. 0 selects light. i selects layer i of
/// `shownLayers`, counted from 1. shownReflections selects the change of light by reflections. `smooth`:
/// true if the object reflects.
[[nodiscard]] inline ThingVariant showing(ThingVariant variant, int layer, bool smooth) {
  if (layer == shownReflections) {
    variant.shade.reflected = true;
  } else if (layer > 0) {
    variant.shade.rays = false;
    variant.shade.shown = layer;
    variant.shade.haze = {};
  }
  if (smooth) return variant;
  variant.stageGroundHeight = false;
  variant.shade.groundReflective = false;
  return variant;
}

/// Lighting of a scene as defines for shading kernels.
struct Lighting {
  ThingVariant variant;
  gl::Defines lights;  ///< defines of the sun's shadow, the lamps and the environment
};

/// Kernel that shades the ground on the tiles that show it.
struct ShadeGround {
  static constexpr auto file = "draw/exact/tiles/shade_ground.comp";
  struct Variant {
    ShadeVariant shade;
    gl::Flag<"SHADOWED"> shadowed;
  };
  TileFields tile;
  SceneLight light;
};

}  // namespace simreel::draw
