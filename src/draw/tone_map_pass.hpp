#pragma once
#include "draw/draw_state.hpp"
#include "draw/targets.hpp"
#include "gl/program.hpp"

namespace simreel::draw {

/// Averages the samples, lays them over the sky, applies exposure, vignette and film curve, and encodes
/// sRGB.
class ToneMapPass {
 public:
  explicit ToneMapPass(int samples);
  void draw(const Targets& targets) const;

 private:
  gl::Program program_;
  VertexArray vertices_;
};

}  // namespace simreel::draw
