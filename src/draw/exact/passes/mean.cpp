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

struct LensShift {
  static constexpr auto file = "draw/exact/screen/lens_shift.comp";
  gl::Ambient<"ViewBlock"> view = {};
  gl::Uniform<"number", int> number;
  gl::Uniform<"lens", glm::vec3> lens;
  gl::In<"nearness"> nearness;
  gl::In<"sums"> light;
  gl::Out<"shifted"> shifted;
};

namespace {

/// Keeps the nearness of each pixel of the band for the shift.
class LensNearnessPass final : public FramePass {
 public:
  explicit LensNearnessPass(ExactFrame& frame) : FramePass(frame) {
    if (!frame.shiftsLens()) return;
    nearest_ = gl::Kernel<LensNearness>(gl::Defines(), {.samples = frame.visibility.variant(),
                                                        .ground = visibleGround(frame.scene) != nullptr});
    frame.lensNearness = gl::Texture::image("nearness for the lens", GL_R32F, frame.size.x, frame.size.y);
  }
  [[nodiscard]] bool on() const override { return f.views > 1 && f.shiftsLens(); }
  void run() override {
    gl::barrier();
    nearest_.dispatch({f.size.x, f.values.rows.y - f.values.rows.x},
                      {.samples = f.visibility.read(), .nearness = f.lensNearness});
  }

 private:
  gl::Kernel<LensNearness> nearest_;
};

/// Shows each pixel through lens points of its own. Glows are added later and are not shifted, because they
/// are not in the visibility buffer and few points of a bright disc would be coarse grain.
class LensShiftPass final : public FramePass {
 public:
  explicit LensShiftPass(ExactFrame& frame) : FramePass(frame) {
    if (!frame.shiftsLens()) return;
    shift_ = gl::Kernel<LensShift>(gl::Defines());
    shifted_ = gl::Texture::image("light through points of a lens", GL_RGBA32F, frame.size.x, frame.size.y);
  }
  [[nodiscard]] bool on() const override { return f.views > 1 && f.shiftsLens(); }
  void run() override {
    gl::barrier();
    shift_.dispatch(f.size, {.number = f.number,
                             .lens = f.lensShiftNow(),
                             .nearness = f.lensNearness,
                             .light = f.light,
                             .shifted = shifted_});
    glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
    glCopyImageSubData(shifted_.name(), GL_TEXTURE_2D, 0, 0, 0, 0, f.light.name(), GL_TEXTURE_2D, 0, 0, 0,
                       0, f.size.x, f.size.y, 1);
    gl::barrier();
  }

 private:
  gl::Kernel<LensShift> shift_;
  gl::Texture shifted_;
};

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

std::unique_ptr<Pass> makeLensNearness(ExactFrame& frame) {
  return std::make_unique<LensNearnessPass>(frame);
}
std::unique_ptr<Pass> makeLensShift(ExactFrame& frame) {
  return std::make_unique<LensShiftPass>(frame);
}
std::unique_ptr<Pass> makeMean(ExactFrame& frame) {
  return std::make_unique<MeanPass>(frame);
}

}  // namespace simreel::draw
