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

/// True if a material visibly reflects the sky. The shaders of other materials contain no sky reflection.
[[nodiscard]] bool isReflective(const scene::Material& material);
[[nodiscard]] bool isReflective(const scene::Ground& ground);
/// True if a surface with this roughness reflects the objects around it (mirrorRough in
/// glsl/draw/exact/reflections/mirror_reach.glsl).
[[nodiscard]] constexpr bool mirrorsScene(float roughness) {
  return roughness < 0.3F;
}

/// Draws surfaces and their materials with the driver's rasterizer. Each combination of material features
/// has its own program, because software drivers execute both sides of a branch.
class SurfacePass {
 public:
  /// Compiles the programs and loads the textures that the scene's materials need.
  SurfacePass(const scene::Scene& scene, const ShadowPass& shadow, const Lamps& lamps);
  /// Draws into the bound framebuffer. A skin whose field is missing is ignored.
  void draw(const sim::Drawables& drawables, const SkinTextures& skins);

 private:
  const gl::Program& program(unsigned features);
  void draw(const sim::Surface& surface, const SkinTextures& skins);
  void setPlain(const scene::Material& material, bool isGrid, const gl::Program& shader);
  static void setSkin(const SkinTextures::Entry& entry, const scene::Skin& skin, const gl::Program& shader);

  gl::Defines defines_;  ///< defines that all programs share
  std::map<unsigned, gl::Program> programs_;
  TextureStore textures_;
  VertexArray vertices_;
};

}  // namespace simreel::draw
