#pragma once
#include "draw/draw_state.hpp"
#include "draw/targets.hpp"
#include "gl/program.hpp"

namespace simreel::draw {

/// Averages the samples, lays them over the sky, applies exposure, vignette and film curve, and encodes
/// sRGB.
class ToneMapPass {
 public:
  ToneMapPass(int samples, bool bloom);
  /// `glow` times `strength` is added to the light; null without bloom.
  void draw(const Targets& targets, const gl::Texture* glow, float strength) const;

 private:
  gl::Program program_;
  VertexArray vertices_;
};

}  // namespace simreel::draw
