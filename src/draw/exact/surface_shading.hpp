#pragma once
#include "draw/exact/shaded_tiles.hpp"
#include "draw/exact/triangle_raster.hpp"
#include "draw/surface/texture_store.hpp"
#include "scene/scene.hpp"

#include <map>

namespace simreel::draw {

/// Shades surfaces where they are visible. A program per combination of features that materials use:
/// software drivers run both sides of a branch.
class SurfaceShading {
 public:
  /// `defines`: SAMPLES and those of the lights.
  /// Loads the textures of the scene's materials.
  SurfaceShading(const scene::Scene& scene, gl::Defines defines);
  /// Adds the light of `drawn`, thing number `thing` of the tiles, to the bound sums.
  void shade(const TriangleRaster& raster, const TriangleRaster::Drawn& drawn, const ShadedTiles& tiles,
             int thing);

 private:
  const gl::Program& program(const sim::Surface& surface);
  static void setTexture(const sim::Surface& surface, const gl::Texture& albedo, const gl::Program& shader);

  gl::Defines defines_;
  std::map<unsigned, gl::Program> programs_;
  TextureStore textures_{TextureStore::Reads::ours};
};

}  // namespace simreel::draw
