#include "draw/exact/bindings.hpp"
#include "draw/exact/scene/exact_frame.hpp"
#include "gl/element_array.hpp"

namespace simreel::draw {

namespace {

/// Returns the objects that may cast shadows, without cut-out and blended surfaces. Surfaces are joined if
/// the frame joins them.
sim::Drawables castingOf(const ExactFrame& frame) {
  sim::Drawables casting = frame.drawables;
  if (frame.joins) casting.surfaces = {frame.joined.surface()};
  return casting;
}

class LampMapsPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.lampMaps.has_value(); }
  void run() override {
    f.lampMaps->draw(castingOf(f), f.lamps, f.instances, &f.transparent);
    f.view.bindUniform(viewBinding, 0, sizeof f.values);
  }
};

class SunMapPass final : public FramePass {
 public:
  explicit SunMapPass(ExactFrame& frame) : FramePass(frame) {
    if (on()) casters_.emplace(TriangleRaster::Into::sunMap, 1);
  }
  [[nodiscard]] bool on() const override { return f.sunMap.has_value(); }
  void run() override {
    const sim::Drawables drawables = castingOf(f);
    std::vector<const sim::Surface*> casting;
    for (const sim::Surface& surface : drawables.surfaces)
      if (castsShadow(surface)) casting.push_back(&surface);
    sim::Drawables bounding = drawables;
    bounding.surfaces.insert(bounding.surfaces.end(), f.transparent.casting().begin(),
                             f.transparent.casting().end());
    f.shadow.fit(bounding, [&](const gl::Buffer& bounds) { f.instances.growBounds(drawables, bounds); });
    f.shadow.bind();
    f.sunMap->clear();
    const MapPart part;  // the offset is 0, because the receivers are offset by their slope
                         // (glsl/draw/exact/shadows/sun_map.glsl)
    casters_->number(casting);
    casters_->draw(*f.sunMap, part);
    f.transparent.castSun(*f.sunMap, part);
    f.instances.castShadows(drawables, *f.sunMap, part);
  }

 private:
  std::optional<TriangleRaster> casters_;
};

}  // namespace

std::unique_ptr<Pass> makeLampMaps(ExactFrame& frame) {
  return std::make_unique<LampMapsPass>(frame);
}
std::unique_ptr<Pass> makeSunMap(ExactFrame& frame) {
  return std::make_unique<SunMapPass>(frame);
}

}  // namespace simreel::draw
