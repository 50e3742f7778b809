#include "draw/exact/bindings.hpp"
#include "draw/exact/scene/exact_scene_state.hpp"
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

}  // namespace simreel::draw
