#pragma once
#include "draw/exact/surface/map_texels.hpp"
#include "draw/exact/surface/skin_texels.hpp"
#include "draw/exact/surface/texel_lists.hpp"
#include "draw/exact/tiles/shaded_tiles.hpp"
#include "draw/exact/triangles/joined_surfaces.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "draw/surface/skin_textures.hpp"
#include "scene/scene.hpp"

#include <functional>
#include <map>
#include <span>
#include <tuple>
#include <utility>

namespace simreel::draw {

/// Shades surfaces where they are visible. A program per combination of features that materials use:
/// software drivers run both sides of a branch.
class SurfaceShading {
 public:
  /// Loads the textures of the materials of the scene, which must outlive it. `defines`: SAMPLES and those
  /// of the lights.
  SurfaceShading(const scene::Scene& scene, gl::Defines defines);
  /// Makes what surfaces read of the skins, which are up to date.
  void prepare(const SkinTextures& skins);
  /// Adds the light of `drawn`, thing number `thing` of the tiles, to the bound sums. A skin whose field is
  /// not there leaves the material as it is without one.
  void shade(const TriangleRaster& raster, const TriangleRaster::Drawn& drawn, const SkinTextures& skins,
             const ShadedTiles& tiles, int thing);
  /// Whether nothing is laid over the surface, so that it may be shaded together with others.
  [[nodiscard]] static bool isPlain(const sim::Surface& surface, const SkinTextures& skins);
  /// The same of such ones, neighbours among joined surfaces.
  void shadeJoined(const JoinedSurfaces& joined, const TriangleRaster& raster,
                   std::span<const TriangleRaster::Drawn> drawn, const ShadedTiles& tiles, int thing);

  /// Whether a surface's opacity is different from place to place; what then kernels that draw it read
  /// (glsl/draw/exact/triangles/cutout.glsl), which leave out what has less than `least`.
  [[nodiscard]] static bool hasHoles(const sim::Surface& surface);
  void setHoles(const sim::Surface& surface, float least, const gl::Program& kernel);
  /// From now on programs have these defines.
  void define(gl::Defines defines) {
    defines_ = std::move(defines);
    programs_.clear();
  }
  /// The map of a material's colour: its finish's own, or its texture.
  [[nodiscard]] static scene::Map colorMapOf(const scene::Material& material);
  /// Whether a texture alone goes on beyond its border; on a sheet that shows the picture once it must not
  /// blend with the opposite one.
  [[nodiscard]] static bool textureRepeats(const sim::Surface& surface);
  /// How rays, for which places are kept instead of being lit, number what those are made of.
  void ownBy(std::function<unsigned(const scene::Material&)> owner) { owner_ = std::move(owner); }
  [[nodiscard]] MapTexels& maps() { return maps_; }
  [[nodiscard]] const SkinTexels& skinTexels() const { return skinTexels_; }
  /// From now on one of `shownLayers` is shaded instead of light, counted from 1; 0: light;
  /// shownReflections: what those change, of surfaces that mirror the scene alone.
  void show(int layer) { shown_ = layer; }
  /// How far away what those show may be, and how thick it is (m).
  void mirrorWithin(glm::vec2 reach) { mirrorReach_ = reach; }
  /// Whether the surface is smooth somewhere.
  [[nodiscard]] static bool mirrorsScene(const sim::Surface& surface, const SkinTextures& skins);

 private:
  /// A look's number is -1 without a skin.
  const gl::Program& program(unsigned features, int look);
  static void setTexture(const sim::Surface& surface, const TexelLists::List& albedo,
                         const gl::Program& shader);

  void setFinish(const sim::Surface& surface, const gl::Program& shader);
  void setSkin(const sim::Surface& surface, const SkinTextures::Entry& entry,
               const gl::Program& shader) const;

  const scene::Scene& scene_;
  gl::Defines defines_;
  int shown_ = 0;
  glm::vec2 mirrorReach_{0};
  std::map<std::tuple<unsigned, int, int>, gl::Program> programs_;  ///< the last: shown_
  TexelLists textures_;
  SkinTexels skinTexels_;
  MapTexels maps_;
  std::function<unsigned(const scene::Material&)> owner_;
};

}  // namespace simreel::draw
