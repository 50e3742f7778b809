#include "draw/exact/scene/exact_frame.hpp"

#include "draw/rows_at_once.hpp"
#include "draw/surface/surface_pass.hpp"
#include "sim/grid/field_display.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace simreel::draw {

namespace {

/// Returns the scene's sun. If the scene is path traced, the returned sun has no shadow map.
scene::Sun mappedSun(const scene::Scene& scene) {
  scene::Sun sun = scene.sun;
  sun.shadow = sun.shadow && scene.render.quality != scene::Quality::high;
  return sun;
}

/// Returns the value of HAZE in glsl/draw/exact/haze.glsl.
gl::Range<"HAZE", 1, 2> hazeVariant(const scene::Scene& scene) {
  if (!scene.haze) return {};
  return scene.haze->color ? 2 : 1;
}

void append(gl::Defines& defines, const gl::Defines& more) {
  defines.insert(defines.end(), more.begin(), more.end());
}

}  // namespace

ExactFrame::ExactFrame(const scene::Scene& shown, const Environment* around, glm::ivec2 pixels, int count,
                       int rows)
    : scene(shown),
      environment(around),
      size(pixels),
      samples(count),
      bandRows(rows),
      ground(visibleGround(shown) != nullptr),
      skins(shown),
      lamps(shown, Rasterizer::exact),
      shadow(mappedSun(shown)),
      view("view", sizeof(shader::ExactView)),
      visibility("the picture", {pixels.x, rows}, count, true, isParallel(shown.camera)),
      triangles(TriangleRaster::Into::picture, count),
      surfaces(shown, {lit(), lights()}),
      transparent({pixels.x, rows}, count, surfaces, isParallel(shown.camera)),
      glass(pixels, {pixels.x, rows}, count, surfaces, isParallel(shown.camera)),
      instances(count, {lit(), lights()}),
      groundShading(lights()),
      light(gl::Texture::image("light", GL_RGBA32F, pixels.x, pixels.y)) {
  if (occludes()) occlusion = Occlusion(pixels, visibility, ground);
  if (lamps.order().shadowed > 0 && !traces()) lampMaps.emplace(lamps);
  if (shadow.on()) sunMap.emplace("the shadow map", shadow.size(), 1, false);
  if (!traces()) return;
  gl::Defines rayLights;
  append(rayLights, lamps.defines());
  append(rayLights, aroundDefines());
  const std::size_t held =
      static_cast<std::size_t>(pixels.x) * static_cast<std::size_t>(rows) * static_cast<std::size_t>(count);
  rays.emplace(
      RayLight::Options{
          .raySamples = shown.render.raySamples, .ground = ground, .openSun = !shown.sun.shadow},
      Lighting{lit(), rayLights}, held, RayMaterials(surfaces.maps(), skins, surfaces.skinTexels()));
  surfaces.setOwnerFunction(
      [this](const scene::Material& material) { return rays->materials().ownerOf(material); });
}

ThingVariant ExactFrame::lit() const {
  return {.shade = {.samples = visibility.variant(),
                    .parallel = isParallel(scene.camera),
                    .fast = scene.numerics == scene::Numerics::fast,
                    .rows = rowsAtOnce(),
                    .occlusion = occludes(),
                    .behind = layered,
                    .rays = traces(),
                    .groundReflective = occludes() && ground && isReflective(*scene.ground),
                    .reflected = false,
                    .shown = {},
                    .haze = hazeVariant(scene)},
          .stageGroundHeight = occludes() && ground};
}

gl::Defines ExactFrame::lights() const {
  gl::Defines defines;
  if (traces()) return scene.haze ? aroundDefines() : defines;
  append(defines, shadow.defines());
  append(defines, lamps.defines());
  append(defines, aroundDefines());
  return defines;
}

SceneLight ExactFrame::sceneLight(const gl::Texture& into) const {
  SceneLight all{.environment = {},
                 .lampBlock = {},
                 .lamps = {},
                 .lampCells = {},
                 .lampShadows = {},
                 .sunPlace = {},
                 .lampKeys = {},
                 .sunMap = {},
                 .openness = {},
                 .nearestLevels = {},
                 .litLevels = {},
                 .mirrorReach = Reflections::reachOf(away()),
                 .litPixels = {},
                 .unevenTiles = {},
                 .refined = refining ? 1 : 0,
                 .layersLeave = transparent.leave(),
                 .through = {},
                 .spots = {},
                 .sums = into,
                 .linear = linear() ? 1 : 0};
  if (lampMaps && lampMaps->on()) all.lampKeys = lampMaps->keys().nearKeys();
  if (sunMap) all.sunMap = sunMap->nearKeys();
  if (occlusion.on()) all.openness = occlusion.openness();
  if (reflections) all.nearestLevels = reflections->nearest();
  if (reflections) all.litLevels = reflections->light();
  if (reflected) all.unevenTiles = reflected->uneven();
  all.litPixels = light;
  if (rays) all.spots = rays->spots();
  return all;
}

bool ExactFrame::behindFields() const {
  const std::vector<sim::Field>& fields = asked.frame.drawables->fields;
  return std::any_of(fields.begin(), fields.end(), [](const sim::Field& field) {
    return field.display != nullptr && field.display->layer == sim::FieldDisplay::Layer::behind;
  });
}

bool ExactFrame::evensLast() const {
  return !mirrors && !glass.any() && views == 1 && passes == nullptr && !wanted &&
         !ExactInstances::anyAdd(drawables) && !behindFields();
}

void ExactFrame::shadeGround(int which, const ShadeGround::Variant& variant, const gl::Texture& into) {
  tiles->shade(tiles->things() + which, groundShading.of(variant),
               ShadeGround{.tile = {}, .light = sceneLight(into)});
}

gl::Defines ExactFrame::aroundDefines() const {
  return environment == nullptr ? gl::Defines() : environment->defines();
}

float ExactFrame::away() const {
  // A view with a field of view of 40 degrees shows a height of 0.73 at distance 1.
  const float distance = seen.parallel ? 2 * seen.reach.y / 0.73F : glm::distance(seen.eye, seen.target);
  return std::max(distance, 1e-5F);
}

GroundPlace ExactFrame::groundPlace() const {
  return {rowsTowardsGround(values, scene.ground->height, ShadedTiles::side),
          groundNearnessOf(values, scene.ground->height), rayBounds(values)};
}

std::vector<DrawnThing> ExactFrame::thingsDrawn() const {
  std::vector<DrawnThing> things;
  for (const TriangleRaster::Drawn& drawn : triangles.drawn())
    things.push_back({objectName(*drawn.surface), "triangle", drawn.firstId, 1});
  transparent.describe(things);
  instances.describe(things);
  return things;
}

void ExactFrame::shadeThings(const gl::Texture& into) {
  const SceneLight all = sceneLight(into);
  for (std::size_t i = 0; i < gathered.size(); ++i)
    if (gathered[i].size() == 1)
      surfaces.shade(triangles, gathered[i].front(), skins, *tiles, static_cast<int>(i), all);
    else
      surfaces.shadeJoined(joined, triangles, gathered[i], *tiles, static_cast<int>(i), all);
  transparent.shade(skins, *tiles, static_cast<int>(gathered.size()), all);
  instances.shade(*tiles, static_cast<int>(gathered.size()) + transparent.things(), all);
}

}  // namespace simreel::draw
