#pragma once
#include "draw/draw_state.hpp"
#include "draw/shadow_pass.hpp"
#include "draw/texture_store.hpp"
#include "gl/program.hpp"
#include "scene/scene.hpp"
#include "sim/drawable.hpp"

#include <map>

namespace simreel::draw {

/// Whether a material mirrors enough of the sky to see; shaders leave the mirror out where it does not.
[[nodiscard]] bool isReflective(const scene::Material& material);

/// Draws surfaces with their materials. A program per combination of features that materials use: software
/// drivers run both sides of a branch.
class SurfacePass {
 public:
  /// Compiles the programs and loads the textures that the scene's materials need.
  SurfacePass(const scene::Scene& scene, const ShadowPass& shadow);
  /// Into the bound framebuffer.
  void draw(const sim::Drawables& drawables);

 private:
  const gl::Program& program(unsigned features);
  void draw(const sim::Surface& surface);

  gl::Defines shadowDefines_;
  std::map<unsigned, gl::Program> programs_;
  TextureStore textures_;
  VertexArray vertices_;
};

}  // namespace simreel::draw
