#include "draw/screen/resolve_pass.hpp"

#include "gl/context.hpp"
#include "sim/grid/field_display.hpp"

#include <algorithm>

namespace simreel::draw {

struct Resolve {
  static constexpr auto file = "draw/screen/resolve.comp";
  struct Variant {
    gl::Range<"SAMPLES", 1, 64> samples;
    gl::Flag<"GLOWS"> glows;
  };
  gl::Ambient<"FrameBlock"> frame = {};
  gl::In<"scene"> light;
  gl::In<"sceneDepth"> depth;
  gl::InOut<"GlowBlock"> glows;
  gl::Out<"resolved"> resolved;
  gl::Uniform<"cleared", int> cleared;
};

ResolvePass::ResolvePass(glm::ivec2 size, int samples) : size_(size), samples_(samples) {
  if (gl::memoryPath() == gl::MemoryPath::texel) return;
  resolved_ = gl::Texture::image("resolved light", GL_RGBA16F, size.x, size.y);
}

bool ResolvePass::needsClearedLight(const sim::Drawables& drawables) const {
  if (!on()) return true;
  return std::any_of(drawables.fields.begin(), drawables.fields.end(),
                     [](const sim::Field& field) {
                       return field.display != nullptr &&
                              field.display->layer == sim::FieldDisplay::Layer::behind;
                     }) ||
         std::any_of(drawables.instances.begin(), drawables.instances.end(),
                     [](const sim::Instances& i) { return i.additive && !GlowSums::takes(i); });
}

const GlowSums* ResolvePass::glows(const sim::Drawables& drawables) {
  const auto& all = drawables.instances;
  if (std::none_of(all.begin(), all.end(), GlowSums::takes)) return nullptr;
  if (!glows_) glows_ = std::make_unique<GlowSums>(size_, samples_);
  return glows_.get();
}

const gl::Texture& ResolvePass::draw(const Targets& targets, const GlowSums* glows, bool cleared) {
  if (!on()) return targets.light;
  kernels_.of({.samples = samples_, .glows = glows != nullptr})
      .dispatch(size_, {.light = targets.light,
                        .depth = targets.depth,
                        .glows = glows != nullptr ? gl::Resource(glows->sums()) : gl::Resource(),
                        .resolved = resolved_,
                        .cleared = static_cast<int>(cleared)});
  return resolved_;
}

}  // namespace simreel::draw
