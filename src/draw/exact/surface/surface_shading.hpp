#pragma once
#include "draw/exact/surface/map_texels.hpp"
#include "draw/exact/surface/skin_texels.hpp"
#include "draw/exact/surface/texel_lists.hpp"
#include "draw/exact/tiles/shaded_tiles.hpp"
#include "draw/exact/triangles/joined_surfaces.hpp"
#include "draw/exact/triangles/laid_fields.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "draw/surface/skin_textures.hpp"
#include "scene/scene.hpp"

#include <functional>
#include <span>
#include <utility>

namespace simreel::draw {

struct SurfaceVariant;
struct ShadeSurface;

/// Shades surfaces where they are visible. A program per combination of features that materials use:
/// software drivers run both sides of a branch.
class SurfaceShading {
 public:
  /// Loads the textures of the materials of the scene, which must outlive it.
  SurfaceShading(const scene::Scene& scene, Lighting lighting);
  /// Makes what surfaces read of the skins, which are up to date.
  void prepare(const SkinTextures& skins);
  /// Adds the light of `drawn`, thing number `thing` of the tiles. A skin whose field is not there leaves
  /// the material as it is without one.
  void shade(const TriangleRaster& raster, const TriangleRaster::Drawn& drawn, const SkinTextures& skins,
             const ShadedTiles& tiles, int thing, const SceneLight& light);
  /// Whether nothing is laid over the surface, so that it may be shaded together with others.
  [[nodiscard]] static bool isPlain(const sim::Surface& surface, const SkinTextures& skins);
  /// The same of such ones, neighbours among joined surfaces.
  void shadeJoined(const JoinedSurfaces& joined, const TriangleRaster& raster,
                   std::span<const TriangleRaster::Drawn> drawn, const ShadedTiles& tiles, int thing,
                   const SceneLight& light);

  /// Whether a surface's opacity is different from place to place; what then kernels that draw it read,
  /// which leave out what has less than `least`.
  [[nodiscard]] static bool hasHoles(const sim::Surface& surface);
  [[nodiscard]] Cutout holes(const sim::Surface& surface, float least);
  /// From now on things are lit like that, by the same lights.
  void light(const ThingVariant& variant) { lighting_.variant = variant; }
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
  /// Whether the surface is smooth somewhere.
  [[nodiscard]] static bool mirrorsScene(const sim::Surface& surface, const SkinTextures& skins);

 private:
  const gl::Kernel<ShadeSurface>& kernel(const SurfaceVariant& surface, bool smooth);
  // Give what is laid over the surface.
  static void layTexture(const sim::Surface& surface, const TexelLists::List& albedo, ShadeSurface& given);
  void layFinish(const sim::Surface& surface, ShadeSurface& given);
  void laySkin(const sim::Surface& surface, const SkinTextures::Entry& entry, ShadeSurface& given) const;

  const scene::Scene& scene_;
  Lighting lighting_;
  int shown_ = 0;
  gl::Kernels<ShadeSurface> kernels_;
  TexelLists textures_;
  SkinTexels skinTexels_;
  MapTexels maps_;
  std::function<unsigned(const scene::Material&)> owner_;
};

}  // namespace simreel::draw
