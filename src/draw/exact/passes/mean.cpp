#include "draw/exact/scene/exact_frame.hpp"
#include "gl/kernel/kernel.hpp"

namespace simreel::draw {

struct LensSumKernel {
  static constexpr auto file = "draw/exact/screen/lens_sum.comp";
  gl::Ambient<"FrameBlock"> frame = {};
  gl::Ambient<"ViewBlock"> view = {};
  gl::Uniform<"first", int> first;
  gl::Uniform<"share", float> share;
  gl::InOut<"sums"> light;
  gl::InOut<"total"> total;
};

namespace {

/// Computes the mean of all views (moments and lens points).
class MeanPass final : public FramePass {
 public:
  explicit MeanPass(ExactFrame& frame) : FramePass(frame) {
    if (!frame.scene.camera.lens && !frame.scene.camera.shutter) return;
    sum_ = gl::Kernel<LensSumKernel>(gl::Defines());
    total_ = gl::Texture::image("light through the lens", GL_RGBA32F, frame.size.x, frame.size.y);
  }
  [[nodiscard]] bool on() const override { return f.views > 1; }
  void run() override {
    const bool last = f.number + 1 == f.views;
    sum_.dispatch(f.size, {.first = f.number == 0 ? 1 : 0,
                           .share = last ? 1.0F / static_cast<float>(f.views) : 0.0F,
                           .light = f.light,
                           .total = total_});
    gl::barrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    if (f.number == 0) middle_ = exactView(f.seen, f.scene.camera, f.size);
    if (!last) return;
    f.values = middle_;  // the sky is drawn once, through the centre of the lens
    f.tellView();
    if (f.passes != nullptr) f.passes->keepLight("light", "lens", f.light, {0, f.size.y});
  }

 private:
  gl::Kernel<LensSumKernel> sum_;
  gl::Texture total_;           ///< sum of the light of the views so far
  shader::ExactView middle_{};  ///< view of the first moment through the centre of the lens
};

}  // namespace

std::unique_ptr<Pass> makeMean(ExactFrame& frame) {
  return std::make_unique<MeanPass>(frame);
}

}  // namespace simreel::draw
