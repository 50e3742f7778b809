#include "scene/haze_reach.hpp"

#include <algorithm>

namespace simreel::scene {

namespace {

/// Returns the distance from the camera at which haze at the ground's height lets exp(-depths) of the light
/// through, when the haze is thinnest.
float hazedDistance(const Haze& haze, float depths) {
  float longest = 0;
  for (const auto& key : haze.distance.keys()) longest = std::max(longest, key.value);
  return haze.start + depths * longest;
}

}  // namespace

void extendGroundIntoHaze(Scene& scene) {
  if (!scene.haze || !scene.ground || !scene.stage.leaves("ground.fadeStart") ||
      !scene.stage.leaves("ground.fadeEnd"))
    return;
  scene.ground->fadeStart = std::max(scene.ground->fadeStart, hazedDistance(*scene.haze, 5));
  scene.ground->fadeEnd = std::max(scene.ground->fadeEnd, hazedDistance(*scene.haze, 8));
}

void extendViewIntoHaze(Scene& scene) {
  if (scene.haze && scene.camera.projection == Projection::perspective)
    scene.camera.far = std::max(scene.camera.far, hazedDistance(*scene.haze, 16));
}

}  // namespace simreel::scene
