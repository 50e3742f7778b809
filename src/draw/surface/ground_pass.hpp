#pragma once
#include "draw/draw_state.hpp"
#include "draw/lights/lamps.hpp"
#include "draw/surface/shadow_pass.hpp"
#include "gl/program.hpp"
#include "scene/scene.hpp"

namespace simreel::draw {

/// The ground plane, fading out around the camera's target. Draw it last: what stands on it hides it then.
class GroundPass {
 public:
  GroundPass(const scene::Scene& scene, const ShadowPass& shadow, const Lamps& lamps);
  /// Into the bound framebuffer.
  void draw() const;
  [[nodiscard]] bool on() const { return on_; }

 private:
  bool on_;
  bool shadowed_;
  gl::Program lit_, shaded_;  ///< around the rectangle that shadows reach, and inside it
  VertexArray vertices_;
};

}  // namespace simreel::draw
