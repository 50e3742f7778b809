#pragma once
#include "scene/scene.hpp"

#include <span>

#include <glm/vec3.hpp>

namespace simreel::scene {

/// Light and floor of a stage. Colours are linear RGB.
struct StageLook {
  glm::vec3 floor;            ///< linear RGB colour of the lit floor in the picture, and of the background
                              ///< into which the floor fades
  glm::vec3 horizon, zenith;  ///< linear RGB of the sky, which is background and fill light
  float ambient;              ///< factor on the fill light
  glm::vec3 keyColor;
  float key;          ///< illuminance of the key light in lx
  glm::vec3 keyFrom;  ///< direction towards the key light, with the components towards the camera, to the
                      ///< camera's right, and up
  float keyDiameter;  ///< angular diameter of the key light in degrees
  glm::vec3 rimColor;
  float rim;      ///< illuminance of the rim light in the centre of the stage, in lx
  float maximum;  ///< max reflectance of the floor
  bool hasFloor = true;
  float reach = 9.0F;  ///< distance at which the floor has faded completely, in radii of the objects
  Stage::Palette palette = Stage::Palette::vivid;
};

/// Returns the look of a preset. For `automatic`, returns a dark stage if `shining` is true (an object
/// glows), and otherwise the studio.
[[nodiscard]] const StageLook& stageLook(Stage::Preset preset, bool shining);

/// Returns the linear RGB colours of any palette except `preset`. Objects get the colours in this order.
[[nodiscard]] std::span<const glm::vec3> stageColors(Stage::Palette palette);

}  // namespace simreel::scene
