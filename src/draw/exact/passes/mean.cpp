#include "draw/exact/scene/exact_frame.hpp"
#include "draw/lens.hpp"
#include "gl/kernel/kernel.hpp"

namespace simreel::draw {

struct LensSumKernel {
  static constexpr auto file = "draw/exact/screen/lens_sum.comp";
  struct Variant {
    gl::Flag<"LENS"> lens;
    gl::Flag<"MEAN"> mean;
  };
  gl::Ambient<"FrameBlock"> frame = {};
  gl::Ambient<"ViewBlock"> view = {};
  gl::Uniform<"number", int> number = {};
  gl::Uniform<"lens", glm::vec3> lens = {};
  gl::Uniform<"share", float> share = {};
  gl::InOut<"sums"> light;
  gl::In<"nearness"> nearness = {};
  gl::InOut<"total"> total;
};

struct LensNearness {
  static constexpr auto file = "draw/exact/screen/lens_nearness.comp";
  struct Variant {
    SampleVariant samples;
    gl::Flag<"GROUND"> ground;
  };
  gl::Ambient<"FrameBlock"> frame = {};
  gl::Ambient<"ViewBlock"> view = {};
  SamplesRead samples;
  gl::Out<"nearness"> nearness;
};

namespace {

/// True if each pixel looks through lens points of its own.
bool shifts(const ExactFrame& frame) {
  return frame.scene.camera.lens && !frame.visibility.layout().parallel;
}

/// Keeps the nearness of each pixel of the band for the mean.
class LensNearnessPass final : public FramePass {
 public:
  explicit LensNearnessPass(ExactFrame& frame) : FramePass(frame) {
    if (!shifts(frame)) return;
    nearest_ = gl::Kernel<LensNearness>(gl::Defines(), {.samples = frame.visibility.variant(),
                                                        .ground = visibleGround(frame.scene) != nullptr});
    frame.lensNearness = gl::Texture::image("nearness for the lens", GL_R32F, frame.size.x, frame.size.y);
  }
  [[nodiscard]] bool on() const override { return f.views > 1 && shifts(f); }
  void run() override {
    gl::barrier();
    nearest_.dispatch({f.size.x, f.values.rows.y - f.values.rows.x},
                      {.samples = f.visibility.read(), .nearness = f.lensNearness});
  }

 private:
  gl::Kernel<LensNearness> nearest_;
};

/// Computes the mean of all views (moments and lens points).
class MeanPass final : public FramePass {
 public:
  explicit MeanPass(ExactFrame& frame) : FramePass(frame) {
    if (!frame.scene.camera.lens && !frame.scene.camera.shutter) return;
    sum_ = gl::Kernel<LensSumKernel>(gl::Defines(), {.lens = shifts(frame), .mean = false});
    mean_ = gl::Kernel<LensSumKernel>(gl::Defines(), {.lens = false, .mean = true});
    total_ = gl::Texture::image("light through the lens", GL_RGBA32F, frame.size.x, frame.size.y);
  }
  [[nodiscard]] bool on() const override { return f.views > 1; }
  void run() override {
    const bool last = f.number + 1 == f.views;
    if (shifts(f))
      sum_.dispatch(f.size,
                    {.number = f.number,
                     .lens = lensShift(f.scene.camera, f.seen, f.size, f.point.focus, f.moment.seconds),
                     .light = f.light,
                     .nearness = f.lensNearness,
                     .total = total_});
    else
      sum_.dispatch(f.size, {.number = f.number, .light = f.light, .total = total_});
    if (last)
      mean_.dispatch(f.size,
                     {.share = 1.0F / static_cast<float>(f.views), .light = f.light, .total = total_});
    gl::barrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    if (f.number == 0) middle_ = exactView(f.seen, f.scene.camera, f.size);
    if (!last) return;
    f.values = middle_;  // the sky is drawn once, through the centre of the lens
    f.tellView();
    if (f.passes != nullptr) f.passes->keepLight("light", "lens", f.light, {0, f.size.y});
  }

 private:
  gl::Kernel<LensSumKernel> sum_, mean_;
  gl::Texture total_;           ///< sum of the light of the views so far
  shader::ExactView middle_{};  ///< view of the first moment through the centre of the lens
};

}  // namespace

std::unique_ptr<Pass> makeLensNearness(ExactFrame& frame) {
  return std::make_unique<LensNearnessPass>(frame);
}
std::unique_ptr<Pass> makeMean(ExactFrame& frame) {
  return std::make_unique<MeanPass>(frame);
}

}  // namespace simreel::draw
