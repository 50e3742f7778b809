#include "base/ieee.hpp"
#include "draw/exact/scene/exact_frame.hpp"

namespace simreel::draw {

namespace {

/// Builds the ray hierarchy of all objects, including cut-out and blended surfaces.
class RayScenePass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.rays.has_value(); }
  void run() override {
    const double stops = f.scene.render.exposure.at(f.moment.seconds);
    f.white = static_cast<float>(ieee::exp2(-stops));
    sim::Drawables met = f.drawables;
    met.surfaces.insert(met.surfaces.end(), f.transparent.cut().begin(), f.transparent.cut().end());
    met.surfaces.insert(met.surfaces.end(), f.transparent.blended().begin(), f.transparent.blended().end());
    f.rays->build(met);
  }
};

class RayLightPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.rays.has_value(); }
  void run() override { f.addRays(f.visibility); }
};

}  // namespace

std::unique_ptr<Pass> makeRayScene(ExactFrame& frame) {
  return std::make_unique<RayScenePass>(frame);
}
std::unique_ptr<Pass> makeRayLight(ExactFrame& frame) {
  return std::make_unique<RayLightPass>(frame);
}

}  // namespace simreel::draw
