#include "base/log.hpp"
#include "draw/exact/bindings.hpp"
#include "draw/exact/scene/exact_frame.hpp"
#include "draw/exact/scene/overlaid_things.hpp"
#include "draw/frame_values.hpp"

#include <array>
#include <set>
#include <string>

namespace simreel::draw {

namespace {

class SkinsPass final : public FramePass {
 public:
  using FramePass::FramePass;
  void run() override {
    f.skins.update(f.asked.overlays->textures);
    f.surfaces.prepare(f.skins);
  }
};

/// Collects the objects, lights and camera of a moment.
class ThingsPass final : public FramePass {
 public:
  using FramePass::FramePass;
  void run() override {
    if (f.lamps.on()) f.lamps.update(f.moment.seconds, *f.moment.drawables);
    f.drawables = f.lamps.on() ? f.lamps.withGlows(*f.moment.drawables) : *f.moment.drawables;
    sayFinishes();
    overlaid_.apply(f.scene, f.drawables);
    if (!f.traces()) f.glass.extractFrom(f.drawables.surfaces);
    f.transparent.extractFrom(f.drawables.surfaces);
    if (f.transparent.anyBlended()) beginLayers();
    f.seen = viewAt(f.scene.camera, f.moment.seconds, f.size, f.drawables, visibleGround(f.scene));
    f.values = exactView(f.seen, f.scene.camera, f.size);
    f.tellView();
    f.view.bindUniform(viewBinding, 0, sizeof f.values);
  }

 private:
  /// Switches to shading kernels that support blended layers. Scenes without blended surfaces use cheaper
  /// kernels.
  void beginLayers() {
    if (f.layered) return;
    f.layered = true;
    f.surfaces.light(f.lit());
    f.instances.light(f.lit());
  }
  /// Warns once about each object whose material is not fully supported.
  void sayFinishes() {
    for (const sim::Instances& instances : f.drawables.instances)
      if (instances.material != nullptr && instances.material->finish.used() &&
          said_.insert(objectName(instances)).second)
        warn(
            "{}: particles have the colour, roughness and metal of their material; maps, light of its own, "
            "opacity, coats and sheen are of surfaces alone",
            objectName(instances));
  }

  OverlaidThings overlaid_;
  std::set<std::string> said_;  ///< names of objects with an earlier warning
};

class JoinedPass final : public FramePass {
 public:
  using FramePass::FramePass;
  void run() override { f.joins = f.joined.join(f.drawables.surfaces); }
};

/// Starts a view (moment and lens point) with empty light.
class ViewPass final : public FramePass {
 public:
  using FramePass::FramePass;
  void run() override {
    constexpr std::array<GLfloat, 4> none = {0, 0, 0, 0};
    f.values = exactView(f.seen, f.scene.camera, f.size, f.point);
    f.values.rows = {0, 0};  // no band of the view has been drawn yet
    if (f.rays) f.rays->selectLensPoint(f.number, f.views);
    if (!ShadedTiles::emptiesLight()) glClearTexImage(f.light.name(), 0, GL_RGBA, GL_FLOAT, none.data());
  }
};

}  // namespace

std::unique_ptr<Pass> makeSkins(ExactFrame& frame) {
  return std::make_unique<SkinsPass>(frame);
}
std::unique_ptr<Pass> makeThings(ExactFrame& frame) {
  return std::make_unique<ThingsPass>(frame);
}
std::unique_ptr<Pass> makeJoinedSurfaces(ExactFrame& frame) {
  return std::make_unique<JoinedPass>(frame);
}
std::unique_ptr<Pass> makeView(ExactFrame& frame) {
  return std::make_unique<ViewPass>(frame);
}

}  // namespace simreel::draw
