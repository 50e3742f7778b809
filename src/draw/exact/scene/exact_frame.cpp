#include "draw/exact/scene/exact_frame.hpp"

#include "draw/rows_at_once.hpp"
#include "draw/surface/surface_pass.hpp"

#include <algorithm>
#include <string>

#include <glm/geometric.hpp>

namespace simreel::draw {

namespace {

/// Rays need no shadow map.
scene::Sun mappedSun(const scene::Scene& scene) {
  scene::Sun sun = scene.sun;
  sun.shadow = sun.shadow && scene.render.quality != scene::Quality::high;
  return sun;
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
      ground(groundSeen(shown) != nullptr),
      skins(shown),
      lamps(shown, Rasterizer::exact),
      shadow(mappedSun(shown)),
      view("view", sizeof(shader::ExactView)),
      visibility("the picture", {pixels.x, rows}, count, true, isParallel(shown.camera)),
      triangles(TriangleRaster::Into::picture, count),
      surfaces(shown, lighting()),
      apart({pixels.x, rows}, count, surfaces, isParallel(shown.camera)),
      instances(count, lighting()),
      light(gl::Texture::image("light", GL_RGBA32F, pixels.x, pixels.y)) {
  if (occludes()) occlusion = Occlusion(pixels, visibility, ground);
  if (lamps.order().shadowed > 0 && !traces()) lampMaps.emplace(lamps);
  if (shadow.on()) sunMap.emplace("the shadow map", shadow.size(), 1, false);
  if (!traces()) return;
  gl::Defines rayLighting = lighting();
  append(rayLighting, lamps.defines());
  append(rayLighting, aroundDefines());
  const std::size_t held =
      static_cast<std::size_t>(pixels.x) * static_cast<std::size_t>(rows) * static_cast<std::size_t>(count);
  rays.emplace(
      RayLight::Options{
          .raySamples = shown.render.raySamples, .ground = ground, .openSun = !shown.sun.shadow},
      rayLighting, held, RayLooks(surfaces.maps(), skins, surfaces.skinTexels()));
  surfaces.ownBy([this](const scene::Material& material) { return rays->looks().ownerOf(material); });
}

gl::Defines ExactFrame::lighting() const {
  gl::Defines defines = definesOf(visibility.layout());
  if (scene.numerics == scene::Numerics::fast) defines.emplace_back("FAST_NUMERICS", "1");
  defines.emplace_back("SAMPLES", std::to_string(samples));
  defines.emplace_back("ROWS", std::to_string(rowsAtOnce()));
  if (occludes()) defines.emplace_back("OCCLUSION", "1");
  if (occludes() && ground) {
    defines.emplace_back("GROUND_BELOW", "1");
    if (ground && isReflective(*scene.ground)) defines.emplace_back("GROUND_REFLECTIVE", "1");
  }
  if (layered) defines.emplace_back("BEHIND", "1");
  if (traces()) {
    defines.emplace_back("RAYS", "1");
    return defines;
  }
  append(defines, shadow.defines());
  append(defines, lamps.defines());
  append(defines, aroundDefines());
  return defines;
}

gl::Defines ExactFrame::aroundDefines() const {
  return environment == nullptr ? gl::Defines() : environment->defines();
}

float ExactFrame::away() const {
  // At 40 degrees a view is 0.73 times as high as it is far away.
  const float distance = seen.parallel ? 2 * seen.reach.y / 0.73F : glm::distance(seen.eye, seen.target);
  return std::max(distance, 1e-5F);
}

GroundPlace ExactFrame::groundPlace() const {
  return {rowsTowardsGround(values, scene.ground->height, ShadedTiles::side),
          nearOfGround(values, scene.ground->height), raysAside(values)};
}

std::vector<DrawnThing> ExactFrame::thingsDrawn() const {
  std::vector<DrawnThing> things;
  for (const TriangleRaster::Drawn& drawn : triangles.drawn())
    things.push_back({objectName(*drawn.surface), "triangle", drawn.firstId, 1});
  apart.describe(things);
  instances.describe(things);
  return things;
}

void ExactFrame::bindShadows() const {
  if (sunMap) sunMap->nearKeys().bind(mapUnit);
  if (lampMaps) lampMaps->bind();
}

void ExactFrame::shadeThings() {
  for (std::size_t i = 0; i < gathered.size(); ++i)
    if (gathered[i].size() == 1)
      surfaces.shade(triangles, gathered[i].front(), skins, *tiles, static_cast<int>(i));
    else
      surfaces.shadeJoined(joined, triangles, gathered[i], *tiles, static_cast<int>(i));
  apart.shade(skins, *tiles, static_cast<int>(gathered.size()));
  instances.shade(*tiles, static_cast<int>(gathered.size()) + apart.things());
}

}  // namespace simreel::draw
