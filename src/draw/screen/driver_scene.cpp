#include "draw/screen/driver_scene.hpp"

#include "base/log.hpp"
#include "draw/instances/instances_pass.hpp"
#include "draw/lights/lamp_shadows.hpp"
#include "draw/lights/lamps.hpp"
#include "draw/screen/bloom_pass.hpp"
#include "draw/screen/resolve_pass.hpp"
#include "draw/screen/tone_map_pass.hpp"
#include "draw/surface/ground_pass.hpp"
#include "draw/surface/shadow_pass.hpp"
#include "draw/surface/skin_textures.hpp"
#include "draw/surface/surface_pass.hpp"

#include <set>
#include <string>

namespace simreel::draw {

struct DriverScene::State {
  State(const Shared& shared, glm::ivec2 size, int samples)
      : scene(shared.scene),
        fieldTextures(shared.fieldTextures),
        fields(shared.fields),
        picture(shared.picture),
        targets(size, samples),
        skins(scene),
        lamps(scene),
        shadow(scene.sun),
        lampShadows(lamps),
        surfaces(scene, shadow, lamps),
        instances(shadow, lamps, targets.scene, size, samples),
        ground(scene, shadow, lamps),
        resolve(size, samples),
        bloom(scene.render.bloom, size, resolve.samples()),
        toneMap(scene.render, resolve.samples(), bloom.on()) {}

  /// Warns once about each object whose material is not fully supported.
  void sayFinishes(const sim::Drawables& drawables) {
    for (const sim::Surface& surface : drawables.surfaces) {
      if (!surface.material->finish.used() || !saidOf.insert(sim::objectName(surface)).second) continue;
      warn(
          "{}: the driver's rasterizer draws only the colour, roughness and metal of its materials; maps, "
          "emission, opacity, coats and sheen need \"rasterizer\": \"exact\"",
          sim::objectName(surface));
    }
  }

  std::set<std::string> saidOf;  ///< names of objects with an earlier warning
  const scene::Scene& scene;
  const FieldTextures& fieldTextures;
  FieldPass& fields;
  const Picture& picture;
  Targets targets;
  SkinTextures skins;
  Lamps lamps;
  ShadowPass shadow;
  LampShadows lampShadows;
  SurfacePass surfaces;
  InstancesPass instances;
  GroundPass ground;
  ResolvePass resolve;
  BloomPass bloom;
  ToneMapPass toneMap;
};

DriverScene::DriverScene(const Shared& shared, int samples)
    : state_(std::make_unique<State>(
          shared, glm::ivec2(shared.picture.color.width(), shared.picture.color.height()), samples)) {
  const scene::Scene& scene = shared.scene;
  if (scene.sun.diameter > 0 && scene.sun.shadow && !(scene.staged && scene.stage.leaves("sun.diameter")))
    warn(
        "sun.diameter: the driver's rasterizer draws all shadows with one softness (shadowSoftness); "
        "penumbras that grow with distance need \"rasterizer\": \"exact\"");
  if (!scene.sky.picture.empty())
    warn(
        "sky.picture: the driver's rasterizer draws a gradient of the picture's mean light; the picture "
        "itself needs \"rasterizer\": \"exact\"");
  if (scene.camera.lens)
    warn(
        "camera.lens: the driver's rasterizer draws the whole picture sharp; depth of field needs "
        "\"rasterizer\": \"exact\"");
  if (scene.camera.shutter)
    warn(
        "camera.shutter: the driver's rasterizer draws a single moment; motion blur needs \"rasterizer\": "
        "\"exact\"");
  if (scene.render.quality != scene::Quality::draft)
    warn(
        "render.quality: the driver's rasterizer supports only \"draft\"; \"standard\" and \"high\" need "
        "\"rasterizer\": \"exact\"");
}
DriverScene::~DriverScene() = default;

void DriverScene::draw(double seconds, const sim::Drawables& all, const StageCallback& watch) {
  State& s = *state_;
  s.sayFinishes(all);
  if (s.lamps.on()) s.lamps.update(seconds, all);
  const sim::Drawables drawables = s.lamps.on() ? s.lamps.withGlows(all) : all;
  const auto issued = [&](const char* stage, bool any = true) {
    if (watch && any) watch(stage);
  };
  const bool instances = !drawables.instances.empty();
  s.skins.update(s.fieldTextures);
  if (s.shadow.on()) {
    s.shadow.fit(drawables, [&](const gl::Buffer& bounds) { s.instances.growBounds(drawables, bounds); });
    s.instances.cullForLight(drawables);
    s.shadow.draw(drawables, [&] { s.instances.castShadows(drawables); });
    issued("shadow");
  }
  if (s.lampShadows.on()) {
    s.instances.cullForLamps(drawables);
    s.lampShadows.draw(drawables, [&](int cells) { s.instances.castLampShadows(drawables, cells); });
    issued("shadow");
  }
  s.instances.cull(drawables);
  issued("instances", instances);
  const bool cleared = s.resolve.needsClearedLight(drawables);
  s.targets.clear(cleared);
  s.targets.scene.bind();
  s.fields.draw(drawables, sim::FieldDisplay::Layer::behind, seconds);
  s.shadow.bind();
  s.lampShadows.bind();
  s.surfaces.draw(drawables, s.skins);
  issued("surfaces");
  s.instances.drawOpaque(drawables);
  issued("instances", instances);
  s.ground.draw();
  issued("ground", s.ground.on());
  s.instances.drawAdditive(drawables);
  if (s.resolve.on()) {  // From here on, kernels read light and depth. No pass draws into them any more.
    s.picture.framebuffer.bind();
    glTextureBarrier();
  }
  const GlowSums* glows = s.resolve.glows(drawables);
  if (glows != nullptr) s.instances.sumUp(drawables, s.targets.depth, *glows);
  issued("instances", instances);
  const gl::Texture& light = s.resolve.draw(s.targets, glows, cleared);
  const gl::Texture* scattered = s.bloom.on() ? &s.bloom.draw(light) : nullptr;
  issued("bloom", s.bloom.on());
  s.toneMap.draw(light, s.picture, scattered, s.scene.render.bloom.strength.at(seconds));
  issued("tone map");
}

}  // namespace simreel::draw
