#pragma once
#include "draw/draw_state.hpp"
#include "draw/lights/lamps.hpp"
#include "draw/surface/shadow_pass.hpp"
#include "gl/program.hpp"
#include "scene/scene.hpp"

namespace simreel::draw {

/// Draws the ground plane, which fades out around the camera's target. Should be drawn last, because
/// objects in front then hide most of it.
class GroundPass {
 public:
  GroundPass(const scene::Scene& scene, const ShadowPass& shadow, const Lamps& lamps);
  /// Draws into the bound framebuffer.
  void draw() const;
  [[nodiscard]] bool on() const { return on_; }

 private:
  bool on_;
  bool shadowed_;
  gl::Program lit_, shaded_;  ///< programs for the ground outside and inside the rectangle that shadows can
                              ///< reach
  VertexArray vertices_;
};

}  // namespace simreel::draw
