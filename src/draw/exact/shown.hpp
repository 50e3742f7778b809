#pragma once
#include "draw/exact/visibility.hpp"
#include "gl/kernel/kernel.hpp"

#include <glm/vec2.hpp>

// What kernels have in common that shade tiles of the picture.
namespace simreel::draw {

/// Instead of a layer: what reflections of the scene change of the light.
inline constexpr int shownReflections = -1;

/// draw/exact/tiles/shaded_tile.glsl.
struct TileFields {
  gl::Ambient<"FrameBlock"> frame;
  gl::Ambient<"ViewBlock"> view;
  SamplesRead samples;
  gl::In<"tileLists"> lists;
  gl::In<"tileCounts"> counts;
  gl::Uniform<"draw_", int> thing;
  gl::Uniform<"tileCount", int> tileCount;
};

/// The light that falls on things, what keeps it out, and where theirs goes: draw/surface/lighting.glsl and
/// what it stands beside. Lamps, the sun's place and the surroundings stay bound.
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
  gl::In<"nearestLevels"> nearestLevels;  ///< of what mirrors show,
  gl::In<"litLevels"> litLevels;
  gl::Uniform<"mirrorReach", glm::vec2>
      mirrorReach;                    ///< and how far away it may be, and how thick it is (m)
  gl::In<"layersLeave"> layersLeave;  ///< of the light behind layers
  gl::InOut<"ThroughBlock"> through;  ///< the same, for layers themselves
  gl::Shared<"SpotBlock"> spots;      ///< places to be lit by rays
  gl::InOut<"sums"> sums;             ///< light of each pixel
};

struct ShadeVariant {
  SampleVariant samples;
  gl::Flag<"PARALLEL"> parallel;
  gl::Flag<"FAST_NUMERICS"> fast;
  gl::Range<"ROWS", 1, 8> rows;
  gl::Flag<"OCCLUSION"> occlusion;
  gl::Flag<"BEHIND"> behind;  ///< there may be layers before it
  gl::Flag<"RAYS"> rays;
  gl::Flag<"GROUND_REFLECTIVE"> groundReflective;
  gl::Flag<"REFLECTED"> reflected;
  gl::Range<"SHOWN", 1, 8> shown;
};
/// Of things, which smooth ones mirror the ground beneath them of.
struct ThingVariant {
  ShadeVariant shade;
  gl::Flag<"GROUND_BELOW"> groundBelow;
};

/// Changed so that a layer of the picture is shaded instead of light (`shownLayers`, counted from 1; 0: as
/// it is), or shownReflections; of something smooth or not.
[[nodiscard]] inline ThingVariant showing(ThingVariant variant, int layer, bool smooth) {
  if (layer == shownReflections) {
    variant.shade.reflected = true;
  } else if (layer > 0) {
    variant.shade.rays = false;
    variant.shade.shown = layer;
  }
  if (smooth) return variant;
  variant.groundBelow = false;
  variant.shade.groundReflective = false;
  return variant;
}

/// How a scene is lit.
struct Lighting {
  ThingVariant variant;
  gl::Defines lights;  ///< of the sun's shadow, the lamps and the surroundings
};

/// The ground on the tiles that show it.
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
