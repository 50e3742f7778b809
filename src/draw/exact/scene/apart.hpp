#pragma once
#include "draw/exact/passes.hpp"
#include "draw/exact/surface/surface_shading.hpp"
#include "draw/exact/tiles/shaded_tiles.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "draw/exact/visibility.hpp"
#include "gl/buffer.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Surfaces that are not opaque everywhere, which are drawn apart from the others: those with holes, found
/// together with what is opaque, and blended ones. Of these each sample has layers, from the nearest to
/// what is opaque, found one by one (Everitt, "Interactive order-independent transparency", 2001): each is
/// lit for as much as those before it let through, and what is opaque for what is left. The order is that
/// of depth at each sample, of equally near triangles of their numbers, so that it does not depend on the
/// device; a sample has at most `most` layers, and what of blended surfaces lies behind those is left out.
class ApartSurfaces {
 public:
  static constexpr int most = 16;
  /// `band`: the pixels whose visibility is found at once. `parallel`: as SampleKind has it.
  ApartSurfaces(glm::ivec2 band, int samples, SurfaceShading& shading, bool parallel = false);

  /// Takes from a picture's surfaces those that are drawn here.
  void take(std::vector<sim::Surface>& surfaces);
  [[nodiscard]] bool any() const { return !cutSurfaces_.empty() || !blended_.empty(); }
  [[nodiscard]] bool anyBlended() const { return !blended_.empty(); }

  /// Those that cast shadows: with holes where they have them, blended ones where they hide one half of
  /// what lies behind at least.
  [[nodiscard]] const std::vector<sim::Surface>& casting() const { return casting_; }
  void castSun(const Visibility& map, const MapPart& part);
  /// What cuts those holes into what is drawn of one of them.
  [[nodiscard]] TriangleRaster::Fragments holesOf(const sim::Surface* only = nullptr);

  /// Of those with holes, as ExactInstances has it.
  unsigned number(unsigned firstId, std::vector<unsigned>& firstIds);
  void drawNearest(const Visibility& picture) { cut_.drawNearest(picture); }
  void drawNumbers(const Visibility& picture) { cut_.drawNumbers(picture); }
  void describe(std::vector<DrawnThing>& things) const;
  [[nodiscard]] const std::vector<TriangleRaster::Drawn>& drawn() const { return cut_.drawn(); }
  [[nodiscard]] int things() const { return static_cast<int>(cutSurfaces_.size()); }
  void shade(const SkinTextures& skins, const ShadedTiles& tiles, int firstThing, const SceneLight& light);

  /// Those that have been taken: with holes, and blended ones.
  [[nodiscard]] const std::vector<sim::Surface>& cut() const { return cutSurfaces_; }
  [[nodiscard]] const std::vector<sim::Surface>& blended() const { return blended_; }

  /// Adds the light of the layers before what is visible to `sums`. Numbers have to lie beyond `firstId`.
  /// `trace`, if there is one: lights the places that have been kept of a layer.
  void addLayers(const Visibility& picture, unsigned firstId, const SkinTextures& skins, SceneLight light,
                 const gl::Texture& sums, const std::function<void(const Visibility&)>& trace);
  /// What they let through, of each sample.
  [[nodiscard]] const gl::Texture& leave() const { return throughView_; }

 private:
  void makeRoom();
  [[nodiscard]] static float leastOf(const sim::Surface& surface, bool shadow);

  glm::ivec2 band_;
  int samples_;
  bool parallel_;
  SurfaceShading& shading_;
  std::vector<sim::Surface> cutSurfaces_, blended_, casting_;
  TriangleRaster cut_, layer_;
  std::optional<TriangleRaster> sunCasters_;
  std::array<std::optional<Visibility>, 2> layers_;  ///< this layer, and the one before
  std::optional<ShadedTiles> tiles_;                 ///< of a layer
  gl::Buffer through_;                               ///< fraction of light, of each sample
  gl::Texture throughView_;
};

}  // namespace simreel::draw
