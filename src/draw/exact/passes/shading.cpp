#include "draw/exact/bindings.hpp"
#include "draw/exact/scene/exact_frame.hpp"
#include "draw/surface/surface_pass.hpp"

#include <functional>

namespace simreel::draw {

namespace {

/// Adds the light of blended surfaces in front of opaque ones.
class BlendedPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.layered; }
  void run() override {
    f.bindLight();
    if (!f.rays) return add({});
    f.rays->bind();
    add([this](const Visibility& layer) {
      f.addRays(layer);
      f.rays->bind();
    });
  }
  /// The light is there already: a texture that nobody reads takes it.
  void again() override {
    if (!unused_)
      unused_ = gl::Texture::image("light of layers, once more", GL_RGBA32F, f.size.x, f.size.y);
    unused_.bindImage(sumImage, GL_READ_WRITE);
    add({});
  }

 private:
  void add(const std::function<void(const Visibility&)>& trace) {
    f.bindShadows();
    f.apart.addLayers(f.visibility, 0, f.skins, trace);
    f.apart.bind();
  }

  gl::Texture unused_;
};

/// Adds the light of opaque things and of the ground.
class SurfacesPass final : public FramePass {
 public:
  explicit SurfacesPass(ExactFrame& frame) : FramePass(frame) { makeGround(); }
  void run() override {
    if (layered_ != f.layered) makeGround();
    f.bindLight();
    if (f.rays) f.rays->bind();
    f.bindShadows();
    if (f.occlusion.on()) f.occlusion.bind();
    f.shadeThings();
    if (!f.ground) return;
    f.tiles->shade(f.tiles->things(), litGround_);
    if (f.shadow.on()) f.tiles->shade(f.tiles->things() + 1, shadedGround_);
  }

 private:
  void makeGround() {
    layered_ = f.layered;
    if (!f.ground) return;
    gl::Defines defines = f.lighting();
    if (!f.occludes() && f.ground && isReflective(*f.scene.ground))
      defines.emplace_back("GROUND_REFLECTIVE", "1");
    litGround_ = gl::Program::compute("draw/exact/tiles/shade_ground.comp", defines);
    if (!f.shadow.on()) return;
    defines.emplace_back("SHADOWED", "1");
    shadedGround_ = gl::Program::compute("draw/exact/tiles/shade_ground.comp", defines);
  }

  bool layered_ = false;
  gl::Program litGround_, shadedGround_;
};

/// Adds the light of glows. They have no place that could be mirrored, so they come last.
class GlowsPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return ExactInstances::anyAdd(f.drawables); }
  void run() override {
    f.shines = true;
    f.bindLight();
    f.instances.addLight(f.drawables, f.visibility);
  }
};

}  // namespace

std::unique_ptr<Pass> makeBlended(ExactFrame& frame) {
  return std::make_unique<BlendedPass>(frame);
}
std::unique_ptr<Pass> makeSurfaces(ExactFrame& frame) {
  return std::make_unique<SurfacesPass>(frame);
}
std::unique_ptr<Pass> makeGlows(ExactFrame& frame) {
  return std::make_unique<GlowsPass>(frame);
}

}  // namespace simreel::draw
