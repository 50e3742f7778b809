#include "draw/exact/scene/exact_frame.hpp"
#include "draw/exact/shown.hpp"
#include "draw/surface/surface_pass.hpp"
#include "gl/element_array.hpp"

#include <algorithm>

namespace simreel::draw {

namespace {

/// True if the ground is visible and reflects the scene.
bool groundMirrors(const ExactFrame& frame) {
  return frame.ground && frame.occludes() && mirrorsScene(frame.scene.ground->roughness);
}

/// Determines whether any object reflects the scene.
class MirrorsPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.occludes(); }
  void run() override {
    const auto mirror = [this](const sim::Surface& surface) {
      return SurfaceShading::mirrorsScene(surface, f.skins);
    };
    const auto any = [&](const std::vector<sim::Surface>& surfaces) {
      return std::any_of(surfaces.begin(), surfaces.end(), mirror);
    };
    f.mirrors = groundMirrors(f) || ExactInstances::anyMirrors(f.drawables) || any(f.drawables.surfaces) ||
                any(f.transparent.cut());
    if (!f.mirrors) return;
    if (!f.reflections) f.reflections.emplace(f.size, f.ground, isParallel(f.scene.camera));
    if (!f.reflected) f.reflected.emplace(f.size);
  }
};

class MirroredPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.mirrors; }
  void run() override {
    f.reflections->see(f.light, f.occlusion.nearness());
    f.reflected->clear();
  }
};

/// Computes the change of the band's light that reflections cause.
class ReflectedPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.mirrors; }
  void run() override { trace(f); }
  static void trace(ExactFrame& frame) {
    frame.selectLayer(shownReflections);
    frame.shadeThings(frame.reflected->changes());
    frame.selectLayer(0);
    if (groundMirrors(frame))
      for (int i = 0; i < (frame.shadow.on() ? 2 : 1); ++i)
        frame.shadeGround(i,
                          {.shade = showing(frame.lit(), shownReflections, true).shade, .shadowed = false},
                          frame.reflected->changes());
    gl::barrier();
  }
};

/// Finds where the reflections of neighbouring pixels differ.
class UnevenPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.mirrors; }
  void run() override { f.reflected->findUneven(f.light); }
};

/// Computes the change of the band's light again for each pixel where the reflections of neighbouring
/// pixels differ.
class RefinedPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.mirrors; }
  void run() override {
    f.refining = true;
    ReflectedPass::trace(f);
    f.refining = false;
  }
};

/// Adds the changes of all bands to the light of the view.
class SpreadPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.mirrors; }
  void run() override { f.reflected->spread(f.light); }
};

}  // namespace

std::unique_ptr<Pass> makeMirrors(ExactFrame& frame) {
  return std::make_unique<MirrorsPass>(frame);
}
std::unique_ptr<Pass> makeMirrored(ExactFrame& frame) {
  return std::make_unique<MirroredPass>(frame);
}
std::unique_ptr<Pass> makeUneven(ExactFrame& frame) {
  return std::make_unique<UnevenPass>(frame);
}
std::unique_ptr<Pass> makeRefined(ExactFrame& frame) {
  return std::make_unique<RefinedPass>(frame);
}
std::unique_ptr<Pass> makeSpread(ExactFrame& frame) {
  return std::make_unique<SpreadPass>(frame);
}
std::unique_ptr<Pass> makeReflected(ExactFrame& frame) {
  return std::make_unique<ReflectedPass>(frame);
}

}  // namespace simreel::draw
