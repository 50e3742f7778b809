#include "draw/exact/bindings.hpp"
#include "draw/exact/scene/exact_scene_state.hpp"
#include "draw/exact/shown.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <functional>

namespace simreel::draw {

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

void ExactScene::State::shadeThings(const ShadedTiles& on) {
  for (std::size_t i = 0; i < gathered.size(); ++i)
    if (gathered[i].size() == 1)
      surfaces.shade(triangles, gathered[i].front(), skins, on, static_cast<int>(i));
    else
      surfaces.shadeJoined(joined, triangles, gathered[i], on, static_cast<int>(i));
  apart.shade(skins, on, static_cast<int>(gathered.size()));
  instances.shade(on, static_cast<int>(gathered.size()) + apart.things());
}

void ExactScene::State::shadeAll() {
  bindShadows();
  if (occlusion.on()) occlusion.bind();
  shadeThings(tiles);
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
    shadeThings(tiles);
    if (!ground) continue;
    tiles.shade(tiles.things(), shownGround[i]);
    if (shadow.on()) tiles.shade(tiles.things() + 1, shownGround[i]);
  }
  surfaces.show(0);
  instances.show(0);
  sums.bindImage(sumImage, GL_READ_WRITE);
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

GroundPlace ExactScene::State::groundPlace(const shader::ExactView& values) const {
  return {rowsTowardsGround(values, scene.ground.height, ShadedTiles::side),
          nearOfGround(values, scene.ground.height), raysAside(values)};
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
  tiles.list(firstIds, visibility, groundPlace(values),
             ExactInstances::anyAdd(drawables) || layerKeeper || layered);
  if (layerKeeper) keepLayers(values);
  if (shareKeeper) shareKeeper->add(visibility.readNumbers(), values, thingsDrawn());
  if (passes != nullptr) keepVisibility(rows);
  if (rays) rays->bind();
  if (layered) {
    bindShadows();
    const auto trace = [&](const Visibility& layer) {
      rays->add(layer, sums, rows.y - rows.x, white);
      rays->bind();
    };
    apart.addLayers(visibility, 0, skins, rays ? trace : std::function<void(const Visibility&)>());
    apart.bind();
  }
  shadeAll();
  if (rays) rays->add(visibility, sums, rows.y - rows.x, white);
  if (layerKeeper) shadeShown();
  if (watch) watch("surfaces");
  const bool whole = bandRows >= size.y;
  if (mirrors && whole) {
    reflections->see(sums, occlusion.nearness());
    shadeReflections(tiles);
    if (watch) watch("reflections");
  }
  if (!mirrors || whole) finishBand(drawables, rows, watch);
}

/// What has no place that could be mirrored comes last.
void ExactScene::State::finishBand(const sim::Drawables& drawables, glm::ivec2 rows, const Watch& watch) {
  if (passes != nullptr) passes->keepLight("light", "", sums, rows);
  instances.addLight(drawables, visibility);
  if (watch && ExactInstances::anyAdd(drawables)) watch("instances");
}

bool ExactScene::State::anyMirrors(const sim::Drawables& drawables) const {
  const auto mirror = [&](const sim::Surface& surface) {
    return SurfaceShading::mirrorsScene(surface, skins);
  };
  return static_cast<bool>(mirrorGround) || ExactInstances::anyMirrors(drawables) ||
         std::any_of(drawables.surfaces.begin(), drawables.surfaces.end(), mirror) ||
         std::any_of(apart.cut().begin(), apart.cut().end(), mirror);
}

/// Of what has been shaded in the band; the light of all of the picture has been seen.
void ExactScene::State::shadeReflections(const ShadedTiles& on) {
  sums.bindImage(sumImage, GL_READ_WRITE);
  occlusion.bind();
  reflections->bind();
  surfaces.show(shownReflections);
  instances.show(shownReflections);
  shadeThings(on);
  if (mirrorGround)
    for (int i = 0; i < (shadow.on() ? 2 : 1); ++i) on.shade(on.things() + i, mirrorGround);
  surfaces.show(0);
  instances.show(0);
}

/// To a band of a picture that has been shaded band by band: what it shows is found once more.
void ExactScene::State::addReflections(const sim::Drawables& drawables, const shader::ExactView& values) {
  const std::vector<unsigned> firstIds = findVisible(drawables);
  if (!again) again.emplace(visibility, ground, shadow.on(), false);
  sums.bindImage(sumImage, GL_READ_WRITE);
  again->list(firstIds, visibility, groundPlace(values), ExactInstances::anyAdd(drawables) || layered);
  if (layered) {
    if (!unused) unused = gl::Texture::image("light of layers, once more", GL_RGBA32F, size.x, size.y);
    unused.bindImage(sumImage, GL_READ_WRITE);
    bindShadows();
    apart.addLayers(visibility, 0, skins, {});
    apart.bind();
  }
  shadeReflections(*again);
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
  if (mirrors && bandRows < size.y) {
    reflections->see(sums, occlusion.nearness());
    eachBand([&] {
      addReflections(drawables, values);
      finishBand(drawables, values.rows, watch);
    });
    if (watch) watch("reflections");
  }
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

}  // namespace simreel::draw
