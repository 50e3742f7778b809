#include "draw/exact/scene/exact_frame.hpp"

#include <algorithm>

namespace simreel::draw {

namespace {

class NearnessPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.occlusion.on(); }
  void run() override {
    f.occlusion.add(f.visibility, f.values,
                    f.mirrors ? f.reflections->pixelNearness() : Occlusion::PixelNearness());
  }
};

/// Computes ambient occlusion. Needs the whole view because occluders may be in another band.
class OpennessPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.occlusion.on(); }
  void run() override { f.occlusion.find(f.values, radius()); }

 private:
  [[nodiscard]] float radius() const {
    if (f.scene.render.occlusionRadius) return static_cast<float>(*f.scene.render.occlusionRadius);
    return std::max(f.away() / 6.0F, 1e-6F);
  }
};

}  // namespace

std::unique_ptr<Pass> makeNearness(ExactFrame& frame) {
  return std::make_unique<NearnessPass>(frame);
}
std::unique_ptr<Pass> makeOpenness(ExactFrame& frame) {
  return std::make_unique<OpennessPass>(frame);
}

}  // namespace simreel::draw
