#include "draw/exact/scene/exact_frame.hpp"
#include "gl/element_array.hpp"

namespace simreel::draw {

namespace {

/// Finds the nearest primitive at each sample of the band.
class VisibilityPass final : public FramePass {
 public:
  using FramePass::FramePass;
  void run() override {
    number();
    gl::barrier();  // Waits because another pass may still read the previous band.
    f.visibility.clear();
    f.instances.drawNearest(f.visibility);  // Must run before the triangles write their ids.
    f.transparent.drawNearest(f.visibility);
    if (f.joins)
      f.triangles.drawJoined(f.visibility, f.joined);
    else
      f.triangles.draw(f.visibility);
    f.transparent.drawIds(f.visibility);
    f.instances.drawIds(f.visibility);
  }

 private:
  void number() {
    std::vector<const sim::Surface*> shown;
    for (const sim::Surface& surface : f.drawables.surfaces) shown.push_back(&surface);
    f.triangles.number(shown);
    gather();
    f.firstIds.clear();
    unsigned next = 0;
    for (const auto& together : f.gathered) {
      f.firstIds.push_back(together.front().firstId);
      next = together.back().firstId + static_cast<unsigned>(together.back().maxTriangles);
    }
    next = f.transparent.number(next, f.firstIds);
    f.instances.number(f.drawables, next, f.firstIds);
  }
  /// Groups the surfaces for shading. Consecutive plain surfaces among joined surfaces form one group.
  /// Other surfaces are shaded one by one.
  void gather() {
    const std::span<const TriangleRaster::Drawn> drawn = f.triangles.drawn();
    const bool joins = f.joins && !f.showsUv();
    f.gathered.clear();
    bool before = false;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      const bool plain = joins && SurfaceShading::isPlain(*drawn[i].surface, f.skins);
      if (plain && before)
        f.gathered.back() = drawn.subspan(i - f.gathered.back().size(), f.gathered.back().size() + 1);
      else
        f.gathered.push_back(drawn.subspan(i, 1));
      before = plain;
    }
  }
};

class TilesPass final : public FramePass {
 public:
  explicit TilesPass(ExactFrame& frame)
      : FramePass(frame), tiles_(frame.visibility, frame.ground, frame.shadow.on()) {}
  void run() override {
    list(tiles_, ExactInstances::anyAdd(f.drawables) || f.keepsLayers() || f.layered || f.glass.any());
  }
  void restoreBand() override {
    if (!again_) again_.emplace(f.visibility, f.ground, f.shadow.on(), false);
    list(*again_, ExactInstances::anyAdd(f.drawables) || f.layered || f.glass.any());
  }

 private:
  void list(ShadedTiles& tiles, bool groundKeys) {
    tiles.list(f.firstIds, f.visibility, f.light, f.groundPlace(), groundKeys);
    f.tiles = &tiles;
  }

  ShadedTiles tiles_;
  std::optional<ShadedTiles> again_;  ///< tile lists for bands that are restored; making them does not
                                      ///< clear the band's light
};

}  // namespace

std::unique_ptr<Pass> makeVisibility(ExactFrame& frame) {
  return std::make_unique<VisibilityPass>(frame);
}
std::unique_ptr<Pass> makeTiles(ExactFrame& frame) {
  return std::make_unique<TilesPass>(frame);
}

}  // namespace simreel::draw
