#include "draw/exact/scene/apart.hpp"

#include "gl/element_array.hpp"

#include <cstddef>

namespace simreel::draw {

namespace {

constexpr float visibleOpacity = 1.0F / 512;  ///< max opacity that cannot change an 8-bit pixel
constexpr float shadingOpacity = 0.5F;        ///< min opacity at which blended surfaces cast shadows

std::vector<const sim::Surface*> pointersTo(const std::vector<sim::Surface>& surfaces) {
  std::vector<const sim::Surface*> pointers;
  for (const sim::Surface& surface : surfaces) pointers.push_back(&surface);
  return pointers;
}

}  // namespace

TransparentSurfaces::TransparentSurfaces(glm::ivec2 band, int samples, SurfaceShading& shading,
                                         bool parallel)
    : band_(band),
      samples_(samples),
      parallel_(parallel),
      shading_(shading),
      cut_(TriangleRaster::ofFragments(TriangleRaster::Into::picture, samples)),
      layer_(TriangleRaster::ofFragments(TriangleRaster::Into::picture, samples)) {
  cut_.tellFragments({.cut = SurfaceShading::hasHoles, .holes = [this](const sim::Surface& surface) {
                        return shading_.holes(surface, minimumOf(surface, false));
                      }});
}

float TransparentSurfaces::minimumOf(const sim::Surface& surface, bool shadow) {
  const scene::Finish& finish = surface.material->finish;
  return finish.alpha == scene::Alpha::cut ? finish.cutoff : shadow ? shadingOpacity : visibleOpacity;
}

TriangleRaster::Fragments TransparentSurfaces::holesOf(const sim::Surface* only) {
  return {
      .cut = SurfaceShading::hasHoles,
      .holes =
          [this](const sim::Surface& surface) { return shading_.holes(surface, minimumOf(surface, true)); },
      .only = only};
}

void TransparentSurfaces::extractFrom(std::vector<sim::Surface>& surfaces) {
  cutSurfaces_.clear();
  blended_.clear();
  casting_.clear();
  std::vector<sim::Surface> others;
  for (const sim::Surface& surface : surfaces) {
    const scene::Finish& finish = surface.material->finish;
    const bool holes = SurfaceShading::hasHoles(surface);
    const bool even = !holes && finish.alpha == scene::Alpha::cut;
    if (finish.alpha == scene::Alpha::opaque || (even && finish.opacity >= finish.cutoff)) {
      others.push_back(surface);
      continue;
    }
    if (even || finish.opacity < visibleOpacity) continue;
    (finish.alpha == scene::Alpha::cut ? cutSurfaces_ : blended_).push_back(surface);
    if (castsShadow(surface) && (holes || finish.opacity >= minimumOf(surface, true)))
      casting_.push_back(surface);
  }
  surfaces = std::move(others);
}

void TransparentSurfaces::castSun(const Visibility& map, const MapPart& part) {
  if (casting_.empty()) return;
  if (!sunCasters_) {
    sunCasters_.emplace(TriangleRaster::ofFragments(TriangleRaster::Into::sunMap, 1));
    sunCasters_->tellFragments(holesOf());
  }
  sunCasters_->number(pointersTo(casting_));
  sunCasters_->draw(map, part);
}

unsigned TransparentSurfaces::number(unsigned firstId, std::vector<unsigned>& firstIds) {
  cut_.number(pointersTo(cutSurfaces_), firstId);
  unsigned next = firstId;
  for (const TriangleRaster::Drawn& drawn : cut_.drawn()) {
    firstIds.push_back(drawn.firstId);
    next = drawn.firstId + static_cast<unsigned>(drawn.maxTriangles);
  }
  return next;
}

void TransparentSurfaces::describe(std::vector<DrawnThing>& things) const {
  for (const TriangleRaster::Drawn& drawn : cut_.drawn())
    things.push_back({objectName(*drawn.surface), "triangle", drawn.firstId, 1});
}

void TransparentSurfaces::shade(const SkinTextures& skins, const ShadedTiles& tiles, int firstObject,
                                const SceneLight& light) {
  for (const TriangleRaster::Drawn& drawn : cut_.drawn())
    shading_.shade(cut_, drawn, skins, tiles, firstObject++, light);
}

void TransparentSurfaces::makeRoom() {
  if (through_.name() != 0) return;
  for (auto& layer : layers_) layer.emplace("a layer", band_, samples_, true, parallel_);
  tiles_.emplace(*layers_[0], false, false, false);
  const std::size_t samples = static_cast<std::size_t>(band_.x) * static_cast<std::size_t>(band_.y) *
                              static_cast<std::size_t>(samples_);
  through_ = gl::Buffer("what layers let through", samples * sizeof(float));
  throughView_ = gl::Texture::view("what layers let through", GL_R32F, through_, sizeof(float));
}

void TransparentSurfaces::addLayers(const Visibility& picture, unsigned firstId, const SkinTextures& skins,
                                    SceneLight light, const gl::Texture& sums,
                                    const std::function<void(const Visibility&)>& trace) {
  constexpr float all = 1;
  makeRoom();
  light.through = through_;
  light.sums = sums;
  gl::barrier();
  glClearNamedBufferData(through_.name(), GL_R32F, GL_RED, GL_FLOAT, &all);
  layer_.number(pointersTo(blended_), firstId);
  std::vector<unsigned> firstIds;
  for (const TriangleRaster::Drawn& drawn : layer_.drawn()) firstIds.push_back(drawn.firstId);
  for (int i = 0; i < maximum; ++i) {
    const Visibility& layer = *layers_[static_cast<std::size_t>(i % 2)];
    layer_.tellFragments({.cut = SurfaceShading::hasHoles,
                          .holes =
                              [this](const sim::Surface& surface) {
                                return shading_.holes(surface, minimumOf(surface, false));
                              },
                          .layers = true,
                          .before = i == 0 ? nullptr : &*layers_[static_cast<std::size_t>((i + 1) % 2)],
                          .behind = &picture});
    gl::barrier();
    layer.clear();
    layer_.draw(layer);
    tiles_->list(firstIds, layer, sums, {});
    if (!tiles_->any()) break;
    int thing = 0;
    for (const TriangleRaster::Drawn& drawn : layer_.drawn())
      shading_.shade(layer_, drawn, skins, *tiles_, thing++, light);
    if (trace) trace(layer);
  }
}

}  // namespace simreel::draw
