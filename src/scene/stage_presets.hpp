#pragma once
#include "scene/scene.hpp"

#include <span>

#include <glm/vec3.hpp>

namespace simreel::scene {

/// Light and floor of a stage. Colours are linear RGB.
struct StageLook {
  glm::vec3 floor;            ///< colour that the lit floor shows, and that it fades into
  glm::vec3 horizon, zenith;  ///< background and fill light
  float ambient;              ///< factor on the fill light
  glm::vec3 keyColor;
  float key;          ///< illuminance, lx
  glm::vec3 keyFrom;  ///< direction towards the key light: to the camera, to its right, up
  float keyDiameter;  ///< degrees
  glm::vec3 rimColor;
  float rim;   ///< illuminance in the middle of the stage, lx
  float most;  ///< max reflectance of the floor
  bool hasFloor = true;
  float reach = 9.0F;  ///< distance at which the floor has faded, in radii of the objects
  Stage::Palette palette = Stage::Palette::vivid;
};

/// Returns the look of a preset. For `automatic`: a dark stage if `shining` (some object glows), else
/// studio.
[[nodiscard]] const StageLook& stageLook(Stage::Preset preset, bool shining);

/// Returns the colours of a palette other than `preset`, in the order of objects; linear RGB.
[[nodiscard]] std::span<const glm::vec3> stageColors(Stage::Palette palette);

}  // namespace simreel::scene
