#include "draw/surface/ground_pass.hpp"

#include "draw/frame_values.hpp"
#include "draw/surface/surface_pass.hpp"

namespace simreel::draw {

GroundPass::GroundPass(const scene::Scene& scene, const ShadowPass& shadow, const Lamps& lamps)
    : on_(visibleGround(scene) != nullptr), shadowed_(shadow.on()) {
  if (!on_) return;
  gl::Defines defines = withFrame(shadow.defines());
  defines.insert(defines.end(), lamps.defines().begin(), lamps.defines().end());
  if (on_ && isReflective(*scene.ground)) defines.emplace_back("GROUND_REFLECTIVE", "1");
  lit_ = gl::Program::graphics("draw/surface/ground.vert", "draw/surface/ground.frag", defines);
  if (!shadowed_) return;
  defines.emplace_back("SHADOWED", "1");
  shaded_ = gl::Program::graphics("draw/surface/ground.vert", "draw/surface/ground.frag", defines);
}

void GroundPass::draw() const {
  constexpr int rectangle = 6;  // number of vertices of a rectangle (two triangles)
  constexpr int strips = 4 * rectangle;
  if (!on_) return;
  DrawState{}.set();
  vertices_.bind();
  lit_.use();
  glDrawArrays(GL_TRIANGLES, 0, strips);
  if (!shadowed_) return;
  shaded_.use();
  glDrawArrays(GL_TRIANGLES, 0, rectangle);
}

}  // namespace simreel::draw
