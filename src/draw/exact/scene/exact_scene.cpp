#include "base/error.hpp"
#include "base/ieee.hpp"
#include "base/log.hpp"
#include "draw/exact/bindings.hpp"
#include "draw/exact/exact_view.hpp"
#include "draw/exact/instances/exact_instances.hpp"
#include "draw/exact/occlusion/occlusion.hpp"
#include "draw/exact/rays/ray_light.hpp"
#include "draw/exact/scene/apart.hpp"
#include "draw/exact/scene/exact_scene_state.hpp"
#include "draw/exact/scene/lamp_maps.hpp"
#include "draw/exact/screen/bloom.hpp"
#include "draw/exact/screen/light_pictures.hpp"
#include "draw/exact/shown.hpp"
#include "draw/exact/surface/surface_shading.hpp"
#include "draw/exact/tiles/shaded_tiles.hpp"
#include "draw/exact/triangles/joined_surfaces.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "draw/frame_values.hpp"
#include "draw/rows_at_once.hpp"
#include "draw/surface/shadow_pass.hpp"
#include "draw/surface/surface_pass.hpp"
#include "gl/element_array.hpp"
#include "gl/limits.hpp"
#include "sim/grid/field_display.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

namespace simreel::draw {

namespace {

void checkSamples(int samples) {
  if (samples != 1 && samples != 2 && samples != 4 && samples != 8 && samples != 16)
    fail(ExitCode::usage, "{} samples per pixel: the exact rasterizer has 1, 2, 4, 8 and 16", samples);
}

bool anyBehind(const sim::Drawables& drawables) {
  return std::any_of(drawables.fields.begin(), drawables.fields.end(), [](const sim::Field& field) {
    return field.display != nullptr && field.display->layer == sim::FieldDisplay::Layer::behind;
  });
}

/// Rays need no shadow map.
scene::Sun mappedSun(const scene::Scene& scene) {
  scene::Sun sun = scene.sun;
  sun.shadow = sun.shadow && scene.render.quality != scene::Quality::high;
  return sun;
}

/// As many bytes of visibility as rays have room for places.
std::size_t bytesOfBands(const scene::Scene& scene, std::size_t bytes) {
  if (scene.render.quality != scene::Quality::high) return bytes;
  return std::min(bytes, RayLight::mostSamples * Visibility::sampleBytes);
}

}  // namespace

int rowsOfBands(glm::ivec2 size, int samples, const BandRoom& room) {
  const std::size_t pixels = std::min(room.samples / static_cast<std::size_t>(samples),
                                      static_cast<std::size_t>(room.glowBytes / GlowRaster::sumBytes));
  const std::size_t rows = pixels / static_cast<std::size_t>(size.x);
  if (rows >= static_cast<std::size_t>(size.y)) return size.y;
  constexpr int side = ShadedTiles::side;
  return std::min(size.y, std::max(static_cast<int>(rows) / side * side, side));
}

ExactScene::State::State(const scene::Scene& shown, const Environment* around, glm::ivec2 pixels, int count,
                         int rows)
    : scene(shown),
      environment(around),
      size(pixels),
      samples(count),
      bandRows(rows),
      ground(shown.hasGround && shown.ground.visible),
      skins(shown),
      lamps(shown, Rasterizer::exact),
      shadow(mappedSun(shown)),
      view("view", sizeof(shader::ExactView)),
      visibility("the picture", {pixels.x, rows}, count, true, isParallel(shown.camera)),
      triangles(TriangleRaster::Into::picture, count),
      tiles(visibility, ground, shadow.on()),
      surfaces(shown, lighting(count)),
      apart({pixels.x, rows}, count, surfaces, isParallel(shown.camera)),
      instances(count, lighting(count)),
      bloom(shown.render.bloom, pixels),
      picture(gl::Program::compute("draw/exact/screen/picture.comp", pictureDefines())),
      sums(gl::Texture::image("light", GL_RGBA32F, pixels.x, pixels.y)) {
  if (occludes()) occlusion = Occlusion(pixels, visibility, ground);
  if (lamps.order().shadowed > 0 && !traces()) lampMaps.emplace(lamps);
  if (traces()) {
    const std::size_t held = static_cast<std::size_t>(pixels.x) * static_cast<std::size_t>(rows) *
                             static_cast<std::size_t>(count);
    rays.emplace(
        RayLight::Options{
            .raySamples = shown.render.raySamples, .ground = ground, .openSun = !shown.sun.shadow},
        rayLighting(count), held, RayLooks(surfaces.maps(), skins, surfaces.skinTexels()));
    surfaces.ownBy([this](const scene::Material& material) { return rays->looks().ownerOf(material); });
  }
  if (shown.camera.hasLens || shown.camera.hasShutter) {
    lensSum = gl::Program::compute("draw/exact/screen/lens_sum.comp", {});
    total = gl::Texture::image("light through the lens", GL_RGBA32F, pixels.x, pixels.y);
  }
  if (shadow.on()) {
    map.emplace("the shadow map", shadow.size(), 1, false);
    casters.emplace(TriangleRaster::Into::sunMap, 1);
  }
  makeGround();
}

void ExactScene::State::makeGround() {
  if (!ground) return;
  const scene::Scene& shown = scene;
  gl::Defines defines = lighting(samples);
  if (!occludes() && isReflective(shown.ground)) defines.emplace_back("GROUND_REFLECTIVE", "1");
  litGround = gl::Program::compute("draw/exact/tiles/shade_ground.comp", defines);
  if (occludes() && mirrorsScene(shown.ground.roughness))
    mirrorGround =
        gl::Program::compute("draw/exact/tiles/shade_ground.comp", showing(defines, shownReflections));
  if (!shadow.on()) return;
  defines.emplace_back("SHADOWED", "1");
  shadedGround = gl::Program::compute("draw/exact/tiles/shade_ground.comp", defines);
}

/// What shades is made anew for scenes with blended surfaces, so that others do not pay for them.
void ExactScene::State::beginLayers() {
  if (layered) return;
  layered = true;
  surfaces.define(lighting(samples));
  instances.define(lighting(samples));
  makeGround();
}

ExactScene::ExactScene(const scene::Scene& scene, const Environment* environment, glm::ivec2 size,
                       int samples, std::size_t visibilityBytes) {
  checkSamples(samples);
  const BandRoom room{
      std::min(bytesOfBands(scene, visibilityBytes) / Visibility::sampleBytes, Visibility::maxSamples()),
      gl::limits().storageBlockBytes};
  state_ = std::make_unique<State>(scene, environment, size, samples, rowsOfBands(size, samples, room));
}
ExactScene::~ExactScene() = default;

void ExactScene::keepPasses(PassPicture* passes) {
  state_->passes = passes;
}

void ExactScene::keepLayers(const LightRequest& wanted) {
  State& s = *state_;
  s.wanted = wanted;
  gl::Defines defines = s.pictureDefines();
  defines.emplace_back(wanted.filmed ? "DEEP" : "LINEAR", "1");
  s.linear = gl::Program::compute("draw/exact/screen/picture.comp", defines);
  s.light = gl::Texture::image("light before the film", GL_RGBA32F, s.size.x, s.size.y);
  for (std::size_t i = 0; i < shownLayers.size(); ++i) {
    if (std::find(wanted.layers.begin(), wanted.layers.end(), shownLayers[i]) == wanted.layers.end())
      continue;
    s.shown[i] = gl::Texture::image("a layer of the picture", GL_RGBA32F, s.size.x, s.size.y);
    if (s.ground)
      s.shownGround[i] = gl::Program::compute("draw/exact/tiles/shade_ground.comp",
                                              showing(s.lighting(s.samples), static_cast<int>(i) + 1));
  }
}

PictureLayers ExactScene::takeLayers() {
  return std::move(state_->layers);
}

void ExactScene::draw(const Exposure& exposure, const Moment& frame, const Overlays& overlays,
                      const gl::Texture& picture, const Watch& watch) {
  State& s = *state_;
  const double seconds = frame.seconds;
  const sim::Drawables& drawables = *frame.drawables;
  if (s.environment != nullptr) s.environment->bind();
  s.skins.update(overlays.textures);
  s.surfaces.prepare(s.skins);
  const auto issued = [&](const char* stage) {
    if (watch) watch(stage);
  };
  const bool shines = s.expose(exposure, watch);
  if (s.passes && shines) s.passes->keepLight("glow", "glows", s.sums, {0, s.size.y});
  overlays.fields.drawBehind(drawables, seconds, s.sums, true);
  if (s.passes && anyBehind(drawables)) s.passes->keepLight("glow", "fields", s.sums, {0, s.size.y});
  if (s.bloom.on()) {
    const gl::Texture& scattered = s.bloom.draw(s.sums);
    if (s.passes) s.passes->keepLight("bloom", "", scattered, {0, scattered.height()});
    bindLight(scattered, bloomUnit, scatteredImage);
    for (const gl::Program* program : {&s.picture, &s.linear})
      if (*program) program->set("bloomStrength", s.scene.render.bloom.strength.at(seconds));
    issued("bloom");
  }
  bindLight(s.sums, sceneUnit, lightImage);
  picture.bindImage(pictureImage, GL_WRITE_ONLY);
  s.picture.set("perSize", 2.0F / glm::vec2(s.size));
  s.picture.dispatch(s.size.x, (s.size.y + rowsAtOnce() - 1) / rowsAtOnce());
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT |
                  GL_FRAMEBUFFER_BARRIER_BIT | GL_PIXEL_BUFFER_BARRIER_BIT);
  if (s.passes) s.passes->keepBytes("picture", "film", picture);
  if (s.wanted) s.keepLight();
  issued("tone map");
}

}  // namespace simreel::draw
