#include "draw/exact/scene/exact_frame.hpp"
#include "draw/exact/shown.hpp"
#include "draw/surface/surface_pass.hpp"

#include <algorithm>

namespace simreel::draw {

namespace {

/// True if there is a ground that mirrors the scene.
bool groundMirrors(const ExactFrame& frame) {
  return frame.ground && frame.occludes() && mirrorsScene(frame.scene.ground->roughness);
}

/// Finds if something mirrors the scene, and tells shaders how far mirrors reach.
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
                any(f.apart.cut());
    if (!f.mirrors) return;
    if (!f.reflections) f.reflections.emplace(f.size, f.ground, isParallel(f.scene.camera));
    const glm::vec2 reach = Reflections::reachOf(f.away());
    f.surfaces.mirrorWithin(reach);
    f.instances.mirrorWithin(reach);
  }
};

class MirroredPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.mirrors; }
  void run() override { f.reflections->see(f.light, f.occlusion.nearness()); }
};

/// Adds to the band's light the difference that reflections make.
class ReflectedPass final : public FramePass {
 public:
  explicit ReflectedPass(ExactFrame& frame) : FramePass(frame) { makeGround(); }
  [[nodiscard]] bool on() const override { return f.mirrors; }
  void run() override {
    if (layered_ != f.layered) makeGround();
    f.bindLight();
    f.occlusion.bind();
    f.reflections->bind();
    f.show(shownReflections);
    f.shadeThings();
    f.show(0);
    if (!ground_) return;
    ground_.set("mirrorReach", Reflections::reachOf(f.away()));
    for (int i = 0; i < (f.shadow.on() ? 2 : 1); ++i) f.tiles->shade(f.tiles->things() + i, ground_);
  }

 private:
  void makeGround() {
    layered_ = f.layered;
    if (groundMirrors(f))
      ground_ = gl::Program::compute("draw/exact/tiles/shade_ground.comp",
                                     showing(f.lighting(), shownReflections));
  }

  bool layered_ = false;
  gl::Program ground_;
};

}  // namespace

std::unique_ptr<Pass> makeMirrors(ExactFrame& frame) {
  return std::make_unique<MirrorsPass>(frame);
}
std::unique_ptr<Pass> makeMirrored(ExactFrame& frame) {
  return std::make_unique<MirroredPass>(frame);
}
std::unique_ptr<Pass> makeReflected(ExactFrame& frame) {
  return std::make_unique<ReflectedPass>(frame);
}

}  // namespace simreel::draw
