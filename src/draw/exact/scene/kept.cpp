#include "draw/exact/bindings.hpp"
#include "draw/exact/scene/exact_scene_state.hpp"

#include <algorithm>

namespace simreel::draw {

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

/// Of all that has numbers. What is drawn of the moment's surfaces are copies, which share their places.
std::optional<Velocities> ExactScene::State::velocitiesNow() const {
  const std::vector<Layer>& layersWanted = wanted->layers;
  if (exposed->motion == nullptr || std::none_of(layersWanted.begin(), layersWanted.end(), [](Layer layer) {
        return layer == Layer::velocity || layer == Layer::vector;
      }))
    return std::nullopt;
  Velocities velocities(*exposed->motion, exposed->frameSeconds, exposed->part);
  const auto add = [&](const TriangleRaster::Drawn& drawn) {
    const auto same = [&](const sim::Surface& surface) {
      return surface.positions == drawn.surface->positions && surface.indices == drawn.surface->indices &&
             surface.model == drawn.surface->model && surface.object == drawn.surface->object;
    };
    const auto found = std::find_if(there->surfaces.begin(), there->surfaces.end(), same);
    if (found != there->surfaces.end())
      velocities.addSurface(*found, static_cast<std::size_t>(found - there->surfaces.begin()),
                            drawn.firstId, drawn.maxTriangles);
  };
  for (const TriangleRaster::Drawn& drawn : triangles.drawn()) add(drawn);
  for (const TriangleRaster::Drawn& drawn : apart.drawn()) add(drawn);
  for (const ExactInstances::Numbered& drawn : instances.numbered()) {
    const auto same = [&](const sim::Instances& one) {
      return one.positions == drawn.instances->positions && one.object == drawn.instances->object;
    };
    const auto found = std::find_if(there->instances.begin(), there->instances.end(), same);
    if (found != there->instances.end())
      velocities.addInstances(static_cast<std::size_t>(found - there->instances.begin()), drawn.firstId,
                              drawn.each);
  }
  return velocities;
}

/// How the camera moved during the frame, where somebody asks for it.
std::optional<CameraWay> ExactScene::State::cameraWayNow() const {
  const std::vector<Layer>& layersWanted = wanted->layers;
  if (exposed->motion == nullptr ||
      std::find(layersWanted.begin(), layersWanted.end(), Layer::vector) == layersWanted.end())
    return std::nullopt;
  const double seconds = exposed->frameSeconds;
  const View now = viewAt(scene.camera, exposedSeconds, size, *there, groundSeen(scene));
  const View before = viewAt(scene.camera, exposedSeconds - seconds, size,
                             exposed->motion->cameraAt(exposed->part - 1), groundSeen(scene));
  return CameraWay{exactView(now, scene.camera, size), exactView(before, scene.camera, size), seconds};
}

/// What has numbers in the band.
std::vector<DrawnThing> ExactScene::State::thingsDrawn() const {
  std::vector<DrawnThing> things;
  for (const TriangleRaster::Drawn& drawn : triangles.drawn())
    things.push_back({objectName(*drawn.surface), "triangle", drawn.firstId, 1});
  apart.describe(things);
  instances.describe(things);
  return things;
}

void ExactScene::State::keepLayers(const shader::ExactView& values) {
  const std::vector<DrawnThing> things = thingsDrawn();
  const std::optional<Velocities> velocities = velocitiesNow();
  const std::optional<CameraWay> way = cameraWayNow();
  layerKeeper->add(visibility, values, things, velocities ? &*velocities : nullptr, way ? &*way : nullptr,
                   farther);
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

}  // namespace simreel::draw
