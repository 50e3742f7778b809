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

/// Returns the absorption coefficient a (1/m). The material transmits the fraction e^(-a distance) of
/// light.
[[nodiscard]] glm::vec3 absorptionOf(const scene::Finish& finish);

/// The picture behind a layer of glass.
struct GlassLook {
  bool refracts = false;  ///< true: rays are refracted; false: the layer shows what is straight behind it
  bool transparent = false;          ///< true if the picture has no sky
  bool nearest = false;              ///< true for the nearest layer of the picture
  bool last = false;                 ///< true if there is no layer behind it
  const Visibility* next = nullptr;  ///< the layer behind it, with the back sides of solids; if `last`, any
  gl::Resource behind = {};          ///< light behind the layer
};

/// Shades surfaces on the tiles that show them. Each combination of material features has its own kernel,
/// because software drivers execute both sides of a branch.
class SurfaceShading {
 public:
  /// Loads the textures of the scene's materials. The scene must outlive this object.
  SurfaceShading(const scene::Scene& scene, Lighting lighting);
  /// Updates the texel lists of skins. The skin textures must be up to date.
  void prepare(const SkinTextures& skins);
  /// Adds the light of the surface `drawn`, which has index `thing` in the tile lists. A skin whose field
  /// is missing is ignored.
  void shade(const TriangleRaster& raster, const TriangleRaster::Drawn& drawn, const SkinTextures& skins,
             const ShadedTiles& tiles, int thing, const SceneLight& light);
  /// Draws a layer of the glass `drawn` over the light behind it.
  void shadeGlass(const TriangleRaster& raster, const TriangleRaster::Drawn& drawn,
                  const ShadedTiles& tiles, int thing, const SceneLight& light, const GlassLook& look);
  /// True if the surface has no texture, skin or other finish, so it can be shaded together with others.
  [[nodiscard]] static bool isPlain(const sim::Surface& surface, const SkinTextures& skins);
  /// Adds the light of a group of plain surfaces whose triangles are consecutive in the joined mesh.
  void shadeJoined(const JoinedSurfaces& joined, const TriangleRaster& raster,
                   std::span<const TriangleRaster::Drawn> drawn, const ShadedTiles& tiles, int thing,
                   const SceneLight& light);

  /// hasHoles() returns true if the opacity of the surface varies. holes() returns the kernel inputs that
  /// describe the holes. Kernels with these inputs skip samples whose opacity is below `minimum`.
  [[nodiscard]] static bool hasHoles(const sim::Surface& surface);
  [[nodiscard]] Cutout holes(const sim::Surface& surface, float minimum);
  /// Sets the lighting variant that later shade calls use. The lights stay the same.
  void light(const ThingVariant& variant) { lighting_.variant = variant; }
  /// Returns the colour map of a material: the map of its finish, or its texture.
  [[nodiscard]] static scene::Map colorMapOf(const scene::Material& material);
  /// True if the surface's texture repeats beyond its border. False for a sheet that shows an image exactly
  /// once, because opposite borders must not blend.
  [[nodiscard]] static bool textureRepeats(const sim::Surface& surface);
  /// Sets the function that returns a material's index (owner) in the path tracer's material table. Shading
  /// kernels that store spots also store this index.
  void setOwnerFunction(std::function<unsigned(const scene::Material&)> owner) {
    owner_ = std::move(owner);
  }
  [[nodiscard]] MapTexels& maps() { return maps_; }
  [[nodiscard]] const SkinTexels& skinTexels() const { return skinTexels_; }
  /// Selects the output of later shade calls. 0 selects light. i selects layer i of `shownLayers`, counted
  /// from 1. shownReflections selects the change of light by reflections, only on surfaces that reflect the
  /// scene.
  void selectLayer(int layer) { shown_ = layer; }
  /// True if the surface is smooth enough somewhere to reflect the scene.
  [[nodiscard]] static bool mirrorsScene(const sim::Surface& surface, const SkinTextures& skins);

 private:
  const gl::Kernel<ShadeSurface>& kernel(const SurfaceVariant& surface, bool smooth);
  // These functions set the kernel inputs of textures, finishes and skins.
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
