#include "draw/screen/drawn_scene.hpp"

namespace simreel::draw {

std::unique_ptr<scene::Scene> copyForDrawing(const scene::Scene& scene) {
  auto copy = std::make_unique<scene::Scene>();
  copy->title = scene.title;
  copy->seed = scene.seed;
  copy->numerics = scene.numerics;
  copy->render = scene.render;
  copy->time = scene.time;
  copy->camera = scene.camera;
  copy->sun = scene.sun;
  copy->sky = scene.sky;
  copy->stage = scene.stage;
  copy->staged = scene.staged;
  copy->ground = scene.ground;
  copy->lights = scene.lights;
  for (const scene::Object& object : scene.objects)
    copy->objects.push_back({object.name, object.kind, nullptr, object.material, object.materialKeys});
  return copy;
}

std::unique_ptr<scene::Scene> overlaidScene(const scene::Scene& scene) {
  if (scene.render.overlay == scene::Overlay::none) return nullptr;
  std::unique_ptr<scene::Scene> shown = copyForDrawing(scene);
  scene::Render& render = shown->render;
  render.quality = scene::Quality::draft;
  render.exposure = 0.0F;
  render.tone = scene::Tone::plain;
  render.whiteBalance.reset();
  render.vignette = 0;
  render.bloom = {};
  constexpr glm::vec3 background(0.035F);
  shown->sky = {};
  shown->sky.zenith = shown->sky.horizon = shown->sky.ground = background;
  shown->sun.intensity = 0.0F;
  shown->sun.shadow = false;
  shown->ground.reset();
  shown->lights.clear();
  return shown;
}

}  // namespace simreel::draw
