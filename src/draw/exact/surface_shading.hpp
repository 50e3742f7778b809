#pragma once
#include "draw/exact/shaded_tiles.hpp"
#include "draw/exact/texel_lists.hpp"
#include "draw/exact/triangle_raster.hpp"
#include "draw/surface/skin_textures.hpp"
#include "scene/scene.hpp"

#include <map>
#include <utility>

namespace simreel::draw {

/// Shades surfaces where they are visible. A program per combination of features that materials use:
/// software drivers run both sides of a branch.
class SurfaceShading {
 public:
  /// Loads the textures of the scene's materials. `defines`: SAMPLES and those of the lights.
  SurfaceShading(const scene::Scene& scene, gl::Defines defines);
  /// Adds the light of `drawn`, thing number `thing` of the tiles, to the bound sums. A skin whose field is
  /// not there leaves the material as it is without one.
  void shade(const TriangleRaster& raster, const TriangleRaster::Drawn& drawn, const SkinTextures& skins,
             const ShadedTiles& tiles, int thing);

 private:
  /// A look's number is -1 without a skin.
  const gl::Program& program(unsigned features, int look);
  static void setTexture(const sim::Surface& surface, const TexelLists::List& albedo,
                         const gl::Program& shader);

  gl::Defines defines_;
  std::map<std::pair<unsigned, int>, gl::Program> programs_;
  TexelLists textures_;
};

}  // namespace simreel::draw
