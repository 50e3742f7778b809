#include "base/ieee.hpp"
#include "base/log.hpp"
#include "draw/exact/bindings.hpp"
#include "draw/exact/scene/exact_scene_state.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace simreel::draw {

namespace {

/// m to what the camera looks at.
float distanceOf(const View& view) {
  // Of what is seen at 40 degrees from so far away the height is 0.73 times that.
  const float away = view.parallel ? 2 * view.reach.y / 0.73F : glm::distance(view.eye, view.target);
  return std::max(away, 1e-5F);
}

float occlusionRadiusOf(const scene::Scene& scene, const View& view) {
  if (scene.render.occlusionRadius) return static_cast<float>(*scene.render.occlusionRadius);
  return std::max(distanceOf(view) / 6.0F, 1e-6F);
}

}  // namespace

void ExactScene::State::addThrough(int number, int pictures) {
  sums.bindImage(sumImage, GL_READ_WRITE);
  total.bindImage(lightImage, GL_READ_WRITE);
  lensSum.set("first", number == 0 ? 1 : 0);
  lensSum.set("share", number + 1 == pictures ? 1.0F / static_cast<float>(pictures) : 0.0F);
  lensSum.dispatch(size.x, size.y);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                  GL_TEXTURE_UPDATE_BARRIER_BIT);
}

/// Everything that a picture shows, those surfaces included that are drawn apart.
void ExactScene::State::buildRays(const sim::Drawables& drawables) {
  sim::Drawables met = drawables;
  met.surfaces.insert(met.surfaces.end(), apart.cut().begin(), apart.cut().end());
  met.surfaces.insert(met.surfaces.end(), apart.blended().begin(), apart.blended().end());
  rays->build(met);
}

/// Shadow maps, the view and what it is seen through, of a moment. `drawables`: what is there, and room for
/// it with the lamps' own light.
View ExactScene::State::prepare(const Moment& moment, sim::Drawables& drawables, const Watch& watch) {
  if (lamps.on()) lamps.update(moment.seconds, *moment.drawables);
  drawables = lamps.on() ? lamps.withGlows(*moment.drawables) : *moment.drawables;
  sayFinishes(drawables);
  apart.take(drawables.surfaces);
  if (apart.anyBlended()) beginLayers();
  const View seen = viewAt(scene.camera, moment.seconds, size, drawables, groundSeen(scene));
  const shader::ExactView values = exactView(seen, scene.camera, size);
  view.write(0, std::as_bytes(std::span(&values, 1)));
  farther = seen.farther;
  occlusionRadius = occlusionRadiusOf(scene, seen);
  mirrors = occludes() && anyMirrors(drawables);
  if (mirrors) {
    if (!reflections) reflections.emplace(size, ground, isParallel(scene.camera));
    const glm::vec2 reach = Reflections::reachOf(distanceOf(seen));
    surfaces.mirrorWithin(reach);
    instances.mirrorWithin(reach);
    if (mirrorGround.name() != 0) mirrorGround.set("mirrorReach", reach);
  }
  if (rays) {
    white = static_cast<float>(ieee::exp2(-static_cast<double>(scene.render.exposure.at(moment.seconds))));
    buildRays(drawables);
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
  // Passes and layers are kept of the first one, light and objects' shares of the mean.
  PassPicture* const kept = passes;
  if (wanted) {
    const std::vector<Layer>& asked = wanted->layers;
    layerKeeper.emplace(layers, asked, size, samples);
    if (std::find(asked.begin(), asked.end(), Layer::object) != asked.end())
      shareKeeper.emplace(size, samples);
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
    exposed = &exposure;
    there = moment.drawables;
    exposedSeconds = moment.seconds;
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
  if (shareKeeper) shareKeeper->finish(layers, pictures);
  shareKeeper.reset();
  if (exposure.close) exposure.close();
  if (pictures > 1) {
    view.write(0, std::as_bytes(std::span(&middle, 1)));  // the sky is seen through the middle
    if (passes) passes->keepLight("light", "lens", sums, {0, size.y});
    if (watch) watch("lens");
  }
  return shines;
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
  if (traces()) return;
  for (const sim::Surface& surface : drawables.surfaces)
    if (surface.material->finish.transmission > 0 && said.insert(objectName(surface) + " clear").second)
      warn("{}: light goes through it with render.quality \"high\" alone; it is drawn opaque",
           objectName(surface));
}

}  // namespace simreel::draw
