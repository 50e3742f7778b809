#pragma once
#include "draw/draw_state.hpp"
#include "draw/lights/lamps.hpp"
#include "draw/surface/shadow_pass.hpp"
#include "draw/surface/skin_textures.hpp"
#include "draw/surface/texture_store.hpp"
#include "gl/program.hpp"
#include "scene/scene.hpp"
#include "sim/core/drawable.hpp"

#include <map>

namespace simreel::draw {

/// Whether a material mirrors enough of the sky to see; shaders leave the mirror out where it does not.
[[nodiscard]] bool isReflective(const scene::Material& material);
[[nodiscard]] bool isReflective(const scene::Ground& ground);
/// Whether one of that roughness is smooth enough to mirror what stands around it (mirrorRough of
/// glsl/draw/exact/reflections/mirrored_way.glsl).
[[nodiscard]] constexpr bool mirrorsScene(float roughness) {
  return roughness < 0.3F;
}

/// Draws surfaces with their materials. A program per combination of features that materials use: software
/// drivers run both sides of a branch.
class SurfacePass {
 public:
  /// Compiles the programs and loads the textures that the scene's materials need.
  SurfacePass(const scene::Scene& scene, const ShadowPass& shadow, const Lamps& lamps);
  /// Into the bound framebuffer. A skin whose field is not there leaves the material as it is without one.
  void draw(const sim::Drawables& drawables, const SkinTextures& skins);

 private:
  const gl::Program& program(unsigned features);
  void draw(const sim::Surface& surface, const SkinTextures& skins);
  void setPlain(const scene::Material& material, bool isGrid, const gl::Program& shader);
  static void setSkin(const SkinTextures::Entry& entry, const scene::Skin& skin, const gl::Program& shader);

  gl::Defines defines_;  ///< of all programs
  std::map<unsigned, gl::Program> programs_;
  TextureStore textures_;
  VertexArray vertices_;
};

}  // namespace simreel::draw
