#include "draw/exact/scene/glass.hpp"

#include "gl/element_array.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace simreel::draw {

struct KeepLightKernel {
  static constexpr auto file = "draw/exact/screen/keep_light.comp";
  gl::Ambient<"ViewBlock"> view = {};
  gl::In<"sums"> sums;
  gl::Out<"kept"> kept;
};

namespace {

constexpr int pairs = 2;

bool isGlass(const scene::Material& material) {
  return material.finish.transmission > 0 && material.finish.alpha == scene::Alpha::opaque &&
         !material.skin;
}

}  // namespace

GlassSurfaces::GlassSurfaces(glm::ivec2 size, glm::ivec2 band, int samples, SurfaceShading& shading,
                             bool parallel)
    : size_(size),
      band_(band),
      samples_(samples),
      parallel_(parallel),
      shading_(shading),
      raster_(TriangleRaster::ofFragments(TriangleRaster::Into::picture, samples)) {}

void GlassSurfaces::extractFrom(std::vector<sim::Surface>& surfaces) {
  surfaces_.clear();
  std::vector<sim::Surface> others;
  for (const sim::Surface& surface : surfaces) {
    const bool glass = isGlass(*surface.material);
    (glass ? surfaces_ : others).push_back(surface);
    if (glass) surfaces_.back().doubleSided = true;  // rays leave solids through their back sides
  }
  surfaces = std::move(others);
}

void GlassSurfaces::makeRoom() {
  if (!layers_.empty()) return;
  for (int i = 0; i < 2 * pairs; ++i) {
    Visibility visibility("a layer of glass", band_, samples_, true, parallel_);
    ShadedTiles tiles(visibility, false, false, false);
    layers_.push_back({std::move(visibility), std::move(tiles)});
  }
  behind_ = gl::Texture::image("light behind glass", GL_RGBA32F, size_.x, size_.y);
  keep_.emplace(gl::Defines());
}

/// Finds up to `maximum` layers. Returns their number.
int GlassSurfaces::find(int maximum, const Visibility& picture, const gl::Texture& sums) {
  std::vector<unsigned> firstIds;
  for (const TriangleRaster::Drawn& drawn : raster_.drawn()) firstIds.push_back(drawn.firstId);
  for (int i = 0; i < maximum; ++i) {
    Layer& layer = layers_[static_cast<std::size_t>(i)];
    raster_.tellFragments(
        {.cut = [](const sim::Surface&) { return false; },
         .layers = true,
         .before = i == 0 ? nullptr : &layers_[static_cast<std::size_t>(i - 1)].visibility,
         .behind = &picture});
    gl::barrier();
    layer.visibility.clear();
    raster_.draw(layer.visibility);
    layer.tiles.list(firstIds, layer.visibility, sums, {});
    if (!layer.tiles.any()) return i;
  }
  return maximum;
}

void GlassSurfaces::keep(const gl::Texture& sums) const {
  gl::barrier();
  keep_->dispatch(band_, {.sums = sums, .kept = behind_});
  gl::barrier();
}

void GlassSurfaces::add(Pair pair, const Visibility& picture, const SceneLight& light,
                        const gl::Texture& sums, GlassLook look) {
  makeRoom();
  std::vector<const sim::Surface*> shown;
  for (const sim::Surface& surface : surfaces_) shown.push_back(&surface);
  raster_.number(shown);
  const int first = pair == Pair::near ? 0 : 2;
  const int found = find(pair == Pair::near ? 3 : 4, picture, sums);
  for (int i = std::min(found, first + 2); i-- > first;) {
    keep(sums);
    const Layer& layer = layers_[static_cast<std::size_t>(i)];
    look.behind = behind_;
    look.nearest = i == 0;
    look.last = i + 1 >= found;
    look.next = &layers_[static_cast<std::size_t>(look.last ? i : i + 1)].visibility;
    int thing = 0;
    for (const TriangleRaster::Drawn& drawn : raster_.drawn())
      shading_.shadeGlass(raster_, drawn, layer.tiles, thing++, light, look);
  }
  gl::barrier();
}

}  // namespace simreel::draw
