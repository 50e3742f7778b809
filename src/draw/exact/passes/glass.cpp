#include "draw/exact/scene/exact_frame.hpp"

namespace simreel::draw {

namespace {

/// Makes the levels of light and nearness in which rays through glass are followed. With quality "draft",
/// glass shows the picture straight behind it instead.
class BehindGlassPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.glass.any() && f.occludes(); }
  void run() override {
    if (!f.reflections) f.reflections.emplace(f.size, f.ground, isParallel(f.scene.camera));
    f.reflections->see(f.light, f.occlusion.nearness());
  }
};

/// Draws a pair of layers of glass.
class GlassPass final : public FramePass {
 public:
  GlassPass(ExactFrame& frame, GlassSurfaces::Pair pair) : FramePass(frame), pair_(pair) {}
  [[nodiscard]] bool on() const override { return f.glass.any(); }
  void run() override {
    f.glass.add(pair_, f.visibility, f.sceneLight(f.light), f.light,
                {.refracts = f.occludes(), .transparent = f.scene.render.transparent});
  }

 private:
  GlassSurfaces::Pair pair_;
};

}  // namespace

std::unique_ptr<Pass> makeBehindGlass(ExactFrame& frame) {
  return std::make_unique<BehindGlassPass>(frame);
}
std::unique_ptr<Pass> makeFarGlass(ExactFrame& frame) {
  return std::make_unique<GlassPass>(frame, GlassSurfaces::Pair::far);
}
std::unique_ptr<Pass> makeNearGlass(ExactFrame& frame) {
  return std::make_unique<GlassPass>(frame, GlassSurfaces::Pair::near);
}

}  // namespace simreel::draw
