#include "draw/exact/scene/exact_scene.hpp"

#include "base/error.hpp"
#include "base/ieee.hpp"
#include "base/log.hpp"
#include "draw/exact/bindings.hpp"
#include "draw/exact/bloom.hpp"
#include "draw/exact/exact_view.hpp"
#include "draw/exact/instances/exact_instances.hpp"
#include "draw/exact/joined_surfaces.hpp"
#include "draw/exact/light_pictures.hpp"
#include "draw/exact/occlusion.hpp"
#include "draw/exact/rays/ray_light.hpp"
#include "draw/exact/scene/apart.hpp"
#include "draw/exact/scene/lamp_maps.hpp"
#include "draw/exact/shaded_tiles.hpp"
#include "draw/exact/shown.hpp"
#include "draw/exact/surface_shading.hpp"
#include "draw/exact/triangle_raster.hpp"
#include "draw/frame_values.hpp"
#include "draw/rows_at_once.hpp"
#include "draw/surface/shadow_pass.hpp"
#include "gl/element_array.hpp"
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

/// As many rows of the picture as `bytes` hold the visibility of, in whole tiles.
int rowsOfBands(glm::ivec2 size, int samples, std::size_t bytes) {
  const std::size_t held = std::min(bytes / Visibility::sampleBytes, Visibility::maxSamples());
  const std::size_t rows = held / (static_cast<std::size_t>(size.x) * static_cast<std::size_t>(samples));
  if (rows >= static_cast<std::size_t>(size.y)) return size.y;
  constexpr int side = ShadedTiles::side;
  return std::min(size.y, std::max(static_cast<int>(rows) / side * side, side));
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

/// What light finds by way of other things is plainer than what the camera sees.
void tellOfRays(const scene::Scene& scene) {
  const auto laidOver =
      std::count_if(scene.objects.begin(), scene.objects.end(), [](const scene::Object& object) {
        return object.material.hasSkin || !object.material.texture.empty();
      });
  if (laidOver > 0)
    warn(
        "render.quality \"high\": mirrors and light that comes by way of other things know no textures and "
        "skins, but the material's colour");
}

float occlusionRadiusOf(const scene::Scene& scene, const View& view) {
  if (scene.render.occlusionRadius) return static_cast<float>(*scene.render.occlusionRadius);
  return std::max(glm::distance(view.eye, view.target) / 6.0F, 1e-6F);
}

}  // namespace

struct ExactScene::State {
  State(const scene::Scene& shown, const Environment* around, glm::ivec2 pixels, int count, int rows);

  /// Defines of what shades.
  [[nodiscard]] gl::Defines lighting(int count) const {
    gl::Defines defines = definesOf(visibility.layout());
    if (scene.numerics == scene::Numerics::fast) defines.emplace_back("FAST_NUMERICS", "1");
    defines.emplace_back("SAMPLES", std::to_string(count));
    defines.emplace_back("ROWS", std::to_string(rowsAtOnce()));
    if (occludes()) defines.emplace_back("OCCLUSION", "1");
    if (layered) defines.emplace_back("BEHIND", "1");
    if (traces()) {
      defines.emplace_back("RAYS", "1");
      return defines;
    }
    for (const gl::Defines& more : {shadow.defines(), lamps.defines(), aroundDefines()})
      defines.insert(defines.end(), more.begin(), more.end());
    return defines;
  }
  /// Of what lights by rays.
  [[nodiscard]] gl::Defines rayLighting(int count) const {
    gl::Defines defines = lighting(count);
    for (const gl::Defines& more : {lamps.defines(), aroundDefines()})
      defines.insert(defines.end(), more.begin(), more.end());
    return defines;
  }
  [[nodiscard]] bool traces() const { return scene.render.quality == scene::Quality::high; }
  [[nodiscard]] bool occludes() const { return scene.render.quality == scene::Quality::standard; }
  [[nodiscard]] gl::Defines aroundDefines() const {
    return environment == nullptr ? gl::Defines() : environment->defines();
  }
  [[nodiscard]] gl::Defines pictureDefines() const {
    gl::Defines defines = lightDefines();
    for (auto& define : aroundDefines()) defines.push_back(std::move(define));
    for (auto& define : filmDefines(scene.render)) defines.push_back(std::move(define));
    if (scene.render.transparent) defines.emplace_back("TRANSPARENT", "1");
    defines.emplace_back("ROWS", std::to_string(rowsAtOnce()));
    if (bloom.on()) defines.emplace_back("BLOOM", "1");
    if (scene.numerics == scene::Numerics::fast) defines.emplace_back("FAST_NUMERICS", "1");
    return defines;
  }
  void sayFinishes(const sim::Drawables& drawables);
  void makeGround();
  void beginLayers();
  void drawShadows(const sim::Drawables& drawables);
  std::vector<unsigned> findVisible(const sim::Drawables& drawables);
  void findOpenness(const shader::ExactView& values, const Watch& watch);
  void drawBand(const sim::Drawables& drawables, const shader::ExactView& values, const Watch& watch);
  void drawThrough(const sim::Drawables& drawables, shader::ExactView values, const Watch& watch);
  void addThrough(int number, int pictures);
  View prepare(const Moment& moment, sim::Drawables& drawables, const Watch& watch);
  void refuseWhatRaysLack(const sim::Drawables& drawables) const;
  bool expose(const Exposure& exposure, const Watch& watch);
  void gather();
  void bindShadows() const;
  void shadeAll();
  void keepVisibility(glm::ivec2 rows) const;
  void keepLayers(const shader::ExactView& values);
  void keepLight();
  void shadeThings();
  void shadeShown();
  void clearShown() const;
  void keepShown();

  const scene::Scene& scene;
  const Environment* environment;  ///< null: the sky is a gradient
  glm::ivec2 size;
  int samples;
  int bandRows;  ///< of the picture at most, whose visibility there is at once
  bool ground;
  bool layered = false;  ///< whether what shades may be behind layers
  SkinTextures skins;
  Lamps lamps;
  ShadowPass shadow;
  gl::Buffer view;
  std::set<std::string> said;  ///< objects of whose materials something is not drawn
  Visibility visibility;
  JoinedSurfaces joined;
  bool joins = false;  ///< the surfaces of this picture
  TriangleRaster triangles;
  std::vector<std::span<const TriangleRaster::Drawn>> gathered;  ///< surfaces that are shaded together
  std::optional<Visibility> map;
  std::optional<TriangleRaster> casters;
  std::optional<LampMaps> lampMaps;
  ShadedTiles tiles;
  Occlusion occlusion;
  float occlusionRadius = 0;  ///< of this picture (m)
  float white = 1;            ///< light that it shows as white
  SurfaceShading surfaces;
  ApartSurfaces apart;
  unsigned numbers = 0;  ///< that have been given in this band
  ExactInstances instances;
  std::optional<RayLight> rays;
  Bloom bloom;
  gl::Program litGround, shadedGround, lensSum, picture;
  std::array<gl::Program, shownLayers.size()> shownGround;
  std::array<gl::Texture, shownLayers.size()> shown;  ///< those of its layers that are wanted
  PassPicture* passes = nullptr;                      ///< where they are kept
  std::optional<LightRequest> wanted;                 ///< besides pictures
  PictureLayers layers;
  std::optional<LayerKeeper> layerKeeper;  ///< while the layers' view is drawn
  gl::Program linear;                      ///< of those alone
  gl::Texture light;
  gl::Texture sums;          ///< light of each pixel, and in alpha how much of it is covered
  gl::Texture total;         ///< of moments and points of the lens so far, if there are several
  shader::ExactView middle;  ///< of the first moment, where there are several of them
};

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
      visibility("the picture", {pixels.x, rows}, count, true),
      triangles(TriangleRaster::Into::picture, count),
      tiles(visibility, ground, shadow.on()),
      surfaces(shown, lighting(count)),
      apart({pixels.x, rows}, count, surfaces),
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
        rayLighting(count), held);
    tellOfRays(shown);
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
  if (shown.ground.roughness < 0.6F) defines.emplace_back("REFLECTIVE", "1");
  litGround = gl::Program::compute("draw/exact/tiles/shade_ground.comp", defines);
  if (!shadow.on()) return;
  defines.emplace_back("SHADOWED", "1");
  shadedGround = gl::Program::compute("draw/exact/tiles/shade_ground.comp", defines);
}

/// Once of each object that is drawn as copies or balls.
void ExactScene::State::sayFinishes(const sim::Drawables& drawables) {
  for (const sim::Instances& instances : drawables.instances)
    if (instances.material != nullptr && instances.material->finish.used() &&
        said.insert(objectName(instances)).second)
      warn(
          "{}: particles have the colour, roughness and metal of their material; maps, light of its own, "
          "opacity, coats and sheen are of surfaces alone",
          objectName(instances));
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
  state_ = std::make_unique<State>(scene, environment, size, samples,
                                   rowsOfBands(size, samples, bytesOfBands(scene, visibilityBytes)));
}
ExactScene::~ExactScene() = default;

void ExactScene::State::drawShadows(const sim::Drawables& drawables) {
  std::vector<const sim::Surface*> casting;
  for (const sim::Surface& surface : drawables.surfaces)
    if (castsShadow(surface)) casting.push_back(&surface);
  sim::Drawables bounding = drawables;
  bounding.surfaces.insert(bounding.surfaces.end(), apart.casting().begin(), apart.casting().end());
  shadow.fit(bounding, [&] { instances.growBounds(drawables); });
  shadow.bind();
  map->clear();
  gl::barrier();
  // A filter of r texels reads depths up to r + 1 texels of slope away.
  const MapPart part{.slopeOffset = 1.5F + scene.sun.shadowSoftness};
  casters->number(casting);
  casters->draw(*map, part);
  apart.castSun(*map, part);
  instances.castShadows(drawables, *map, part);
}

/// One by one, but for neighbours among joined ones.
void ExactScene::State::gather() {
  const std::span<const TriangleRaster::Drawn> drawn = triangles.drawn();
  gathered.clear();
  bool before = false;
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const bool plain = joins && SurfaceShading::isPlain(*drawn[i].surface, skins);
    if (plain && before)
      gathered.back() = drawn.subspan(i - gathered.back().size(), gathered.back().size() + 1);
    else
      gathered.push_back(drawn.subspan(i, 1));
    before = plain;
  }
}

void ExactScene::State::bindShadows() const {
  if (map) map->nearKeys().bind(mapUnit);
  if (lampMaps) lampMaps->bind();
}

void ExactScene::State::shadeThings() {
  for (std::size_t i = 0; i < gathered.size(); ++i)
    if (gathered[i].size() == 1)
      surfaces.shade(triangles, gathered[i].front(), skins, tiles, static_cast<int>(i));
    else
      surfaces.shadeJoined(joined, triangles, gathered[i], tiles, static_cast<int>(i));
  apart.shade(skins, tiles, static_cast<int>(gathered.size()));
  instances.shade(tiles, static_cast<int>(gathered.size()) + apart.things());
}

void ExactScene::State::shadeAll() {
  bindShadows();
  if (occlusion.on()) occlusion.bind();
  shadeThings();
  if (!ground) return;
  tiles.shade(tiles.things(), litGround);
  if (shadow.on()) tiles.shade(tiles.things() + 1, shadedGround);
}

/// Layers that are shaded as light is, of what is opaque in the band.
void ExactScene::State::shadeShown() {
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (!shown[i]) continue;
    shown[i].bindImage(sumImage, GL_READ_WRITE);
    surfaces.show(static_cast<int>(i) + 1);
    instances.show(static_cast<int>(i) + 1);
    shadeThings();
    if (!ground) continue;
    tiles.shade(tiles.things(), shownGround[i]);
    if (shadow.on()) tiles.shade(tiles.things() + 1, shownGround[i]);
  }
  surfaces.show(0);
  instances.show(0);
  sums.bindImage(sumImage, GL_READ_WRITE);
}

void ExactScene::State::clearShown() const {
  constexpr std::array<GLfloat, 4> none = {0, 0, 0, 0};
  for (const gl::Texture& layer : shown)
    if (layer) glClearTexImage(layer.name(), 0, GL_RGBA, GL_FLOAT, none.data());
}

void ExactScene::State::keepShown() {
  std::vector<float> sum(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (!shown[i]) continue;
    glGetTextureImage(shown[i].name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(sum.size() * sizeof(float)), sum.data());
    layers.keepShown(shownLayers[i], sum);
  }
}

/// What the band's samples show; with its first, shadow maps and what has numbers.
void ExactScene::State::keepVisibility(glm::ivec2 rows) const {
  const glm::ivec2 band(size.x, rows.y - rows.x);
  passes->keep("visibility", "keys", visibility.readKeys(), band, samples);
  passes->keep("visibility", "numbers", visibility.readNumbers(), band, samples);
  if (rows.x > 0) return;
  if (map) passes->keep("shadow", "sun", map->readKeys(), map->size(), 1);
  if (occlusion.on()) passes->keep("shadow", "openness", occlusion.read(), occlusion.size(), 2);
  if (lampMaps) passes->keep("shadow", "lamps", lampMaps->keys().readKeys(), lampMaps->keys().size(), 1);
  for (const TriangleRaster::Drawn& drawn : triangles.drawn())
    passes->things.push_back({objectName(*drawn.surface), "triangle", drawn.firstId, 1});
  apart.describe(passes->things);
  instances.describe(passes->things);
}

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

void ExactScene::State::keepLayers(const shader::ExactView& values) {
  std::vector<DrawnThing> things;
  for (const TriangleRaster::Drawn& drawn : triangles.drawn())
    things.push_back({objectName(*drawn.surface), "triangle", drawn.firstId, 1});
  apart.describe(things);
  instances.describe(things);
  layerKeeper->add(visibility, values, things);
}

/// What picture.comp makes a picture of.
void ExactScene::State::keepLight() {
  light.bindImage(pictureImage, GL_WRITE_ONLY);
  linear.set("perSize", 2.0F / glm::vec2(size));
  linear.dispatch(size.x, (size.y + rowsAtOnce() - 1) / rowsAtOnce());
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  layers.alpha = scene.render.transparent;
  layers.filmed = wanted->filmed;
  layers.bits = wanted->bits;
  layers.light.resize(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  glGetTextureImage(light.name(), 0, GL_RGBA, GL_FLOAT,
                    static_cast<GLsizei>(layers.light.size() * sizeof(float)), layers.light.data());
  // Which of two zeros a minimum is, devices may choose.
  for (float& value : layers.light) value += 0.0F;
}

/// Of the band that the view's block has. First numbers of what is shaded.
std::vector<unsigned> ExactScene::State::findVisible(const sim::Drawables& drawables) {
  std::vector<const sim::Surface*> shown;
  for (const sim::Surface& surface : drawables.surfaces) shown.push_back(&surface);
  triangles.number(shown);
  gather();
  std::vector<unsigned> firstIds;
  numbers = 0;
  for (const auto& together : gathered) {
    firstIds.push_back(together.front().firstId);
    numbers = together.back().firstId + static_cast<unsigned>(together.back().maxTriangles);
  }
  numbers = apart.number(numbers, firstIds);
  instances.number(drawables, numbers, firstIds);
  gl::barrier();  // another band may still be read
  visibility.clear();
  gl::barrier();
  instances.drawNearest(visibility);  // before triangles draw numbers
  apart.drawNearest(visibility);
  if (joins)
    triangles.drawJoined(visibility, joined);
  else
    triangles.draw(visibility);
  apart.drawNumbers(visibility);
  instances.drawNumbers(visibility);
  return firstIds;
}

void ExactScene::State::findOpenness(const shader::ExactView& values, const Watch& watch) {
  occlusion.find(values, occlusionRadius);
  if (watch) watch("occlusion");
}

void ExactScene::State::drawBand(const sim::Drawables& drawables, const shader::ExactView& values,
                                 const Watch& watch) {
  const glm::ivec2 rows = values.rows;
  const std::vector<unsigned> firstIds = findVisible(drawables);
  if (watch) watch("visibility");
  if (occlusion.on() && bandRows >= size.y) {
    occlusion.add(visibility, values);
    findOpenness(values, watch);
  }
  sums.bindImage(sumImage, GL_READ_WRITE);
  const GroundPlace place{rowsTowardsGround(values, scene.ground.height, ShadedTiles::side),
                          nearOfGround(values, scene.ground.height), raysAside(values)};
  tiles.list(firstIds, visibility, place, ExactInstances::anyAdd(drawables) || layerKeeper || layered);
  if (layerKeeper) keepLayers(values);
  if (passes != nullptr) keepVisibility(rows);
  if (rays) rays->bind();
  if (layered) {
    bindShadows();
    apart.addLayers(visibility, 0, skins);
    apart.bind();
  }
  shadeAll();
  if (rays) rays->add(visibility, sums, rows.y - rows.x, white);
  if (layerKeeper) shadeShown();
  if (passes != nullptr) passes->keepLight("light", "", sums, rows);
  if (watch) watch("surfaces");
  instances.addLight(drawables, visibility);
  if (watch && ExactInstances::anyAdd(drawables)) watch("instances");
}

/// The light of the picture as it is seen through a point of the lens.
void ExactScene::State::drawThrough(const sim::Drawables& drawables, shader::ExactView values,
                                    const Watch& watch) {
  constexpr std::array<GLfloat, 4> none = {0, 0, 0, 0};
  if (!ShadedTiles::emptiesLight()) glClearTexImage(sums.name(), 0, GL_RGBA, GL_FLOAT, none.data());
  const auto eachBand = [&](const auto& draw) {
    for (int row = 0; row < size.y; row += bandRows) {
      values.rows = {row, std::min(row + bandRows, size.y)};
      view.write(0, std::as_bytes(std::span(&values, 1)));
      draw();
    }
  };
  // What keeps light out may be in another band.
  if (occlusion.on() && bandRows < size.y) {
    eachBand([&] {
      findVisible(drawables);
      occlusion.add(visibility, values);
    });
    findOpenness(values, watch);
  }
  eachBand([&] { drawBand(drawables, values, watch); });
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void ExactScene::State::addThrough(int number, int pictures) {
  sums.bindImage(sumImage, GL_READ_WRITE);
  total.bindImage(lightImage, GL_READ_WRITE);
  lensSum.set("first", number == 0 ? 1 : 0);
  lensSum.set("share", number + 1 == pictures ? 1.0F / static_cast<float>(pictures) : 0.0F);
  lensSum.dispatch(size.x, size.y);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                  GL_TEXTURE_UPDATE_BARRIER_BIT);
}

void ExactScene::State::refuseWhatRaysLack(const sim::Drawables& drawables) const {
  const char* what = apart.any() ? "has holes or lets light through" : nullptr;
  for (const sim::Surface& surface : drawables.surfaces)
    if (surface.material->finish.coat > 0 || surface.material->finish.sheen != glm::vec3(0))
      what = "has a coat or a sheen";
  if (what != nullptr)
    fail(ExitCode::usage,
         "render.quality \"high\": a surface of the scene {}, which its rays do not know; set it to "
         "\"standard\"",
         what);
}

/// Shadow maps, the view and what it is seen through, of a moment. `drawables`: what is there, and room for
/// it with the lamps' own light.
View ExactScene::State::prepare(const Moment& moment, sim::Drawables& drawables, const Watch& watch) {
  if (lamps.on()) lamps.update(moment.seconds, *moment.drawables);
  drawables = lamps.on() ? lamps.withGlows(*moment.drawables) : *moment.drawables;
  sayFinishes(drawables);
  apart.take(drawables.surfaces);
  if (traces()) refuseWhatRaysLack(drawables);
  if (apart.anyBlended()) beginLayers();
  const View seen = viewAt(scene.camera, moment.seconds, size, drawables);
  const shader::ExactView values = exactView(seen, scene.camera, size);
  view.write(0, std::as_bytes(std::span(&values, 1)));
  occlusionRadius = occlusionRadiusOf(scene, seen);
  if (rays) {
    white = static_cast<float>(ieee::exp2(-static_cast<double>(scene.render.exposure.at(moment.seconds))));
    rays->build(drawables);
    if (watch) watch("rays");
  }
  joins = joined.join(drawables.surfaces);
  sim::Drawables casting = drawables;
  if (joins) casting.surfaces = {joined.surface()};
  if (lampMaps) {
    lampMaps->draw(casting, lamps, instances, &apart);
    if (watch) watch("shadow");
  }
  view.bindUniform(viewBinding, 0, sizeof values);
  if (shadow.on()) {
    drawShadows(casting);
    if (watch) watch("shadow");
  }
  return seen;
}

/// The mean of all moments, and of all points of the lens, into `sums`. Whether it has light that is only
/// added.
bool ExactScene::State::expose(const Exposure& exposure, const Watch& watch) {
  // Passes and layers are kept of the first one, and of the mean.
  PassPicture* const kept = passes;
  if (wanted) {
    layerKeeper.emplace(layers, wanted->layers, size, samples);
    clearShown();
  }
  const int moments = exposure.moments;
  const int points = scene.camera.hasLens ? scene.camera.lens.samples : 1;
  const int pictures = std::max(moments, points);
  bool shines = false;
  int drawn = 0;
  sim::Drawables drawables;
  for (int m = 0; m < moments; ++m) {
    const Moment moment = exposure.at(m);
    const View seen = prepare(moment, drawables, watch);
    const std::vector<LensPoint> opening = lensPoints(scene.camera, seen, moment.seconds);
    // Each moment through points that lie evenly over all of the lens; each point and each moment once at
    // least.
    for (int i = m; i < pictures; i += moments, ++drawn) {
      const LensPoint& point = opening[static_cast<std::size_t>(i % points)];
      if (rays) rays->seeThrough(drawn, pictures);
      drawThrough(drawables, exactView(seen, scene.camera, size, point), watch);
      passes = nullptr;
      if (layerKeeper) keepShown();
      layerKeeper.reset();
      if (pictures > 1) addThrough(drawn, pictures);
    }
    shines = shines || ExactInstances::anyAdd(drawables);
    if (pictures > 1 && m == 0) middle = exactView(seen, scene.camera, size);
  }
  passes = kept;
  if (exposure.close) exposure.close();
  if (pictures > 1) {
    view.write(0, std::as_bytes(std::span(&middle, 1)));  // the sky is seen through the middle
    if (passes) passes->keepLight("light", "lens", sums, {0, size.y});
    if (watch) watch("lens");
  }
  return shines;
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
      if (program->name() != 0) program->set("bloomStrength", s.scene.render.bloom.strength.at(seconds));
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
