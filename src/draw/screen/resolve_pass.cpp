#include "draw/screen/resolve_pass.hpp"

#include "draw/draw_state.hpp"
#include "gl/context.hpp"
#include "sim/grid/field_display.hpp"

#include <algorithm>
#include <string>

namespace simreel::draw {

ResolvePass::ResolvePass(glm::ivec2 size, int samples) : size_(size), samples_(samples) {
  if (gl::memoryPath() == gl::MemoryPath::texel) return;
  program_ = gl::Program::compute("draw/screen/resolve.comp", {{"SAMPLES", std::to_string(samples)}});
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
  if (!glows_) {
    glows_ = std::make_unique<GlowSums>(size_, samples_);
    glowProgram_ = gl::Program::compute("draw/screen/resolve.comp",
                                        {{"SAMPLES", std::to_string(samples_)}, {"GLOWS", "1"}});
  }
  return glows_.get();
}

const gl::Texture& ResolvePass::draw(const Targets& targets, const GlowSums* glows, bool cleared) {
  if (!on()) return targets.light;
  const gl::Program& program = glows != nullptr ? glowProgram_ : program_;
  if (glows != nullptr) {
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    glows->bind();
  }
  program.set("cleared", static_cast<int>(cleared));
  targets.light.bind(sceneUnit);
  targets.depth.bind(depthUnit);
  resolved_.bindImage(targetImage, GL_WRITE_ONLY);
  program.dispatch(size_.x, size_.y);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
  return resolved_;
}

}  // namespace simreel::draw
