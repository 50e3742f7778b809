#include "draw/exact/scene/exact_frame.hpp"
#include "draw/surface/surface_pass.hpp"
#include "gl/element_array.hpp"
#include "gl/kernel/kernel.hpp"

#include <functional>

namespace simreel::draw {

struct EdgesKernel {
  static constexpr auto file = "draw/exact/screen/even_edges.comp";
  gl::Ambient<"FrameBlock"> frame = {};
  gl::Ambient<"ViewBlock"> view = {};
  gl::InOut<"sums"> light;
  gl::Uniform<"linear", int> linear;
};

namespace {

/// Adds the light of blended surfaces in front of opaque ones.
class BlendedPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.layered; }
  void run() override {
    if (!f.rays) return add(f.light, {});
    add(f.light, [this](const Visibility& layer) { f.addRays(layer); });
  }
  /// Restores only the band's data. The light has already been added, so the output goes to an unused
  /// texture.
  void restoreBand() override {
    if (!unused_)
      unused_ = gl::Texture::image("light of layers, once more", GL_RGBA32F, f.size.x, f.size.y);
    add(unused_, {});
  }

 private:
  void add(const gl::Texture& into, const std::function<void(const Visibility&)>& trace) {
    f.transparent.addLayers(f.visibility, 0, f.skins, f.sceneLight(into), into, trace);
  }

  gl::Texture unused_;
};

/// Adds the light of opaque surfaces, instances and the ground.
class SurfacesPass final : public FramePass {
 public:
  using FramePass::FramePass;
  void run() override {
    if (f.scene.render.overlay != scene::Overlay::none) f.selectLayer(shownOverlay(f.scene.render.overlay));
    f.shadeThings(f.light);
    f.selectLayer(0);
    if (f.ground) {
      ShadeGround::Variant ground{.shade = f.lit().shade, .shadowed = false};
      ground.shade.groundReflective = isReflective(*f.scene.ground);
      f.shadeGround(0, ground, f.light);
      ground.shadowed = true;
      if (f.shadow.on()) f.shadeGround(1, ground, f.light);
    }
    gl::barrier();
  }
};

/// Expands compressed light at edges, if later passes read or change the light.
class EdgesPass final : public FramePass {
 public:
  explicit EdgesPass(ExactFrame& frame) : FramePass(frame) {
    if (frame.samples > 1) kernel_ = gl::Kernel<EdgesKernel>(gl::Defines());
  }
  [[nodiscard]] bool on() const override { return f.samples > 1 && !f.evensLast(); }
  void run() override {
    gl::barrier();
    kernel_.dispatch({f.size.x, f.values.rows.y - f.values.rows.x},
                     {.light = f.light, .linear = f.linear() ? 1 : 0});
    gl::barrier();
  }

 private:
  gl::Kernel<EdgesKernel> kernel_;
};

/// Adds the light of glows. Runs last, because reflections cannot use glows, which have no depth.
class GlowsPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return ExactInstances::anyAdd(f.drawables); }
  void run() override {
    f.shines = true;
    f.instances.addLight(f.drawables, f.visibility, f.light);
    gl::barrier();
  }
};

}  // namespace

std::unique_ptr<Pass> makeBlended(ExactFrame& frame) {
  return std::make_unique<BlendedPass>(frame);
}
std::unique_ptr<Pass> makeSurfaces(ExactFrame& frame) {
  return std::make_unique<SurfacesPass>(frame);
}
std::unique_ptr<Pass> makeEdges(ExactFrame& frame) {
  return std::make_unique<EdgesPass>(frame);
}
std::unique_ptr<Pass> makeGlows(ExactFrame& frame) {
  return std::make_unique<GlowsPass>(frame);
}

}  // namespace simreel::draw
