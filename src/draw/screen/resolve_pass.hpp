#pragma once
#include "draw/instances/glow_sums.hpp"
#include "draw/screen/targets.hpp"
#include "gl/kernel/kernel.hpp"

#include <memory>

namespace simreel::draw {

struct Resolve;

/// On the storage path, resolves the scene's samples into one texture for later kernels and adds the sums
/// of glows. On the texel path, later passes read the samples directly, so this pass does nothing.
class ResolvePass {
 public:
  ResolvePass(glm::ivec2 size, int samples);
  /// True on the storage path. On the texel path this pass does nothing.
  [[nodiscard]] bool on() const { return static_cast<bool>(resolved_); }
  /// Returns the samples per pixel of the light that draw() returns.
  [[nodiscard]] int samples() const { return on() ? 1 : samples_; }
  /// True if the light must be cleared, because draw() reads the light of samples without depth. Clearing
  /// is expensive on compute GPUs, because light takes two thirds of the bytes of the render targets.
  [[nodiscard]] bool needsClearedLight(const sim::Drawables& drawables) const;
  /// Returns the sums for additive sprites, or null if the sprites are blended.
  [[nodiscard]] const GlowSums* glows(const sim::Drawables& drawables);
  /// Returns the resolved light. `glows`: result of glows(). `cleared`: true if the light has been cleared.
  const gl::Texture& draw(const Targets& targets, const GlowSums* glows, bool cleared);

 private:
  glm::ivec2 size_;
  int samples_;
  gl::Kernels<Resolve> kernels_;
  gl::Texture resolved_;
  std::unique_ptr<GlowSums> glows_;
};

}  // namespace simreel::draw
