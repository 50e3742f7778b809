#include "draw/exact/scene/exact_frame.hpp"

namespace simreel::draw {

namespace {

/// Stores the keys and ids of the band's samples as pass outputs. For the first band, also stores the
/// shadow maps and the list of objects.
class KeptVisibilityPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.kept() != nullptr; }
  void run() override {
    PassPicture& kept = *f.kept();
    const glm::ivec2 band(f.size.x, f.values.rows.y - f.values.rows.x);
    kept.keep("visibility", "keys", f.visibility.readKeys(), band, f.samples);
    kept.keep("visibility", "numbers", f.visibility.readNumbers(), band, f.samples);
    if (f.values.rows.x > 0) return;
    const auto keepMap = [&](const char* part, const Visibility& map) {
      kept.keep("shadow", part, map.readKeys(), map.size(), 1);
    };
    if (f.sunMap) keepMap("sun", *f.sunMap);
    if (f.occlusion.on()) kept.keep("shadow", "openness", f.occlusion.read(), f.occlusion.size(), 2);
    if (f.lampMaps) keepMap("lamps", f.lampMaps->keys());
    const std::vector<DrawnThing> things = f.thingsDrawn();
    kept.things.insert(kept.things.end(), things.begin(), things.end());
  }
};

class KeptLightPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.kept() != nullptr; }
  void run() override { f.kept()->keepLight("light", "", f.light, f.values.rows); }
};

class KeptGlowPass final : public FramePass {
 public:
  using FramePass::FramePass;
  [[nodiscard]] bool on() const override { return f.passes != nullptr && f.shines; }
  void run() override { f.passes->keepLight("glow", "glows", f.light, {0, f.size.y}); }
};

}  // namespace

std::unique_ptr<Pass> makeKeptVisibility(ExactFrame& frame) {
  return std::make_unique<KeptVisibilityPass>(frame);
}
std::unique_ptr<Pass> makeKeptLight(ExactFrame& frame) {
  return std::make_unique<KeptLightPass>(frame);
}
std::unique_ptr<Pass> makeKeptGlow(ExactFrame& frame) {
  return std::make_unique<KeptGlowPass>(frame);
}

}  // namespace simreel::draw
