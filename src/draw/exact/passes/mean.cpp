#include "draw/exact/bindings.hpp"
#include "draw/exact/scene/exact_frame.hpp"

namespace simreel::draw {

namespace {

/// The mean of all views, of moments and of points of the lens.
class MeanPass final : public FramePass {
 public:
  explicit MeanPass(ExactFrame& frame) : FramePass(frame) {
    if (!frame.scene.camera.lens && !frame.scene.camera.shutter) return;
    sum_ = gl::Program::compute("draw/exact/screen/lens_sum.comp", {});
    total_ = gl::Texture::image("light through the lens", GL_RGBA32F, frame.size.x, frame.size.y);
  }
  [[nodiscard]] bool on() const override { return f.views > 1; }
  void run() override {
    const bool last = f.number + 1 == f.views;
    f.bindLight();
    total_.bindImage(lightImage, GL_READ_WRITE);
    sum_.set("first", f.number == 0 ? 1 : 0);
    sum_.set("share", last ? 1.0F / static_cast<float>(f.views) : 0.0F);
    sum_.dispatch(f.size.x, f.size.y);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                    GL_TEXTURE_UPDATE_BARRIER_BIT);
    if (f.number == 0) middle_ = exactView(f.seen, f.scene.camera, f.size);
    if (!last) return;
    f.values = middle_;  // the sky is seen through the middle
    f.tellView();
    if (f.passes != nullptr) f.passes->keepLight("light", "lens", f.light, {0, f.size.y});
  }

 private:
  gl::Program sum_;
  gl::Texture total_;           ///< light of the views so far
  shader::ExactView middle_{};  ///< the first moment through the middle of the lens
};

}  // namespace

std::unique_ptr<Pass> makeMean(ExactFrame& frame) {
  return std::make_unique<MeanPass>(frame);
}

}  // namespace simreel::draw
