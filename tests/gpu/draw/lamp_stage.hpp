#pragma once
#include "gpu/draw/draw_stage.hpp"

/// Returns a white light without a visible glow.
inline simreel::scene::Light lampAt(glm::vec3 place, float candela, bool shadow) {
  simreel::scene::Light light;
  light.position = place;
  light.color = glm::vec3(1);
  light.intensity = candela;
  light.radius = 0.01F;
  light.glow = 0.0F;
  light.shadow = shadow;
  return light;
}

/// Returns a scene with the camera straight above the plane y = 0. The picture's top points to -z, its
/// height spans 8 m, and there is no light.
inline simreel::scene::Scene fromAbove() {
  simreel::scene::Scene scene = darkScene();
  scene.camera.position = glm::vec3(0, 20, 0);
  scene.camera.fieldOfView = 2.0F * std::atan(4.0F / 20.0F) * 57.29577951F;
  scene.sun.intensity = 0.0F;
  scene.sun.shadow = false;
  scene.ground.emplace();
  scene.ground->height = 0;
  scene.ground->fadeStart = 1000;
  scene.ground->fadeEnd = 2000;
  return scene;
}

/// Returns the point of the plane at the centre of pixel (x, y), for a picture of fromAbove() with `size` x
/// `size` pixels.
inline glm::dvec3 placeOf(int x, int y, int size) {
  return {8 * (x + 0.5) / size - 4, 0, 8 * (y + 0.5) / size - 4};
}
