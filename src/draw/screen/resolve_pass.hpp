#pragma once
#include "draw/instances/glow_sums.hpp"
#include "draw/screen/targets.hpp"
#include "gl/kernel/kernel.hpp"

#include <memory>

namespace simreel::draw {

struct Resolve;

/// On the storage path: one picture of the scene's light for the kernels after it, the glows' sums in it.
/// On the texel path those passes read the samples themselves, and there is nothing to do.
class ResolvePass {
 public:
  ResolvePass(glm::ivec2 size, int samples);
  /// False where there is nothing to do.
  [[nodiscard]] bool on() const { return static_cast<bool>(resolved_); }
  /// Of the light that draw() gives.
  [[nodiscard]] int samples() const { return on() ? 1 : samples_; }
  /// Whether draw() needs light where no depth was written. Cards for computing clear four samples of a
  /// 1280x720 picture in 0.8 ms; two thirds of the bytes are light.
  [[nodiscard]] bool needsClearedLight(const sim::Drawables& drawables) const;
  /// Where additive sprites go, if they go there at all.
  [[nodiscard]] const GlowSums* glows(const sim::Drawables& drawables);
  /// `glows` and `cleared` as above.
  const gl::Texture& draw(const Targets& targets, const GlowSums* glows, bool cleared);

 private:
  glm::ivec2 size_;
  int samples_;
  gl::Kernels<Resolve> kernels_;
  gl::Texture resolved_;
  std::unique_ptr<GlowSums> glows_;
};

}  // namespace simreel::draw
