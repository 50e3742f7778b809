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

/// Draws the surfaces that are not fully opaque. Cut-out surfaces (with holes) are rasterized together with
/// the opaque ones. Blended surfaces are depth-peeled (Everitt, "Interactive order-independent
/// transparency", 2001): the layers of each sample are found one by one from the nearest to the opaque
/// surface. The light of each layer is multiplied by the fraction that the layers in front let through.
/// Layers are ordered by depth, and by primitive id at equal depth, so the order is the same on every
/// device. Only the first `maximum` layers of a sample are drawn.
class TransparentSurfaces {
 public:
  static constexpr int maximum = 16;
  /// `band`: size (pixels) of the bands of visibility. `parallel`: as in SampleKind.
  TransparentSurfaces(glm::ivec2 band, int samples, SurfaceShading& shading, bool parallel = false);

  /// Moves the surfaces that this class draws from `surfaces` into this object.
  void extractFrom(std::vector<sim::Surface>& surfaces);
  [[nodiscard]] bool any() const { return !cutSurfaces_.empty() || !blended_.empty(); }
  [[nodiscard]] bool anyBlended() const { return !blended_.empty(); }

  /// Returns the stored surfaces that cast shadows. These are the cut-out surfaces, with their holes, and
  /// the blended surfaces whose opacity is at least one half.
  [[nodiscard]] const std::vector<sim::Surface>& casting() const { return casting_; }
  void castSun(const Visibility& map, const MapPart& part);
  /// Returns the description of the holes of the surfaces in casting(). `only`: for lamp maps, the surface
  /// to be drawn.
  [[nodiscard]] TriangleRaster::Fragments holesOf(const sim::Surface* only = nullptr);

  /// Assigns primitive ids to the cut-out surfaces, like ExactInstances::number(). Returns the next free
  /// id.
  unsigned number(unsigned firstId, std::vector<unsigned>& firstIds);
  void drawNearest(const Visibility& picture) { cut_.drawNearest(picture); }
  void drawIds(const Visibility& picture) { cut_.drawIds(picture); }
  void describe(std::vector<DrawnThing>& things) const;
  [[nodiscard]] const std::vector<TriangleRaster::Drawn>& drawn() const { return cut_.drawn(); }
  [[nodiscard]] int things() const { return static_cast<int>(cutSurfaces_.size()); }
  void shade(const SkinTextures& skins, const ShadedTiles& tiles, int firstObject, const SceneLight& light);

  /// cut() returns the stored cut-out surfaces, and blended() the stored blended surfaces.
  [[nodiscard]] const std::vector<sim::Surface>& cut() const { return cutSurfaces_; }
  [[nodiscard]] const std::vector<sim::Surface>& blended() const { return blended_; }

  /// Adds the light of the layers in front of `picture` to `sums`. `firstId` is the first primitive id
  /// of the layers. `trace` (optional) is called after each layer and adds its ray-traced light.
  void addLayers(const Visibility& picture, unsigned firstId, const SkinTextures& skins, SceneLight light,
                 const gl::Texture& sums, const std::function<void(const Visibility&)>& trace);
  /// Returns the fraction of light that all layers let through, per sample.
  [[nodiscard]] const gl::Texture& leave() const { return throughView_; }

 private:
  void makeRoom();
  [[nodiscard]] static float minimumOf(const sim::Surface& surface, bool shadow);

  glm::ivec2 band_;
  int samples_;
  bool parallel_;
  SurfaceShading& shading_;
  std::vector<sim::Surface> cutSurfaces_, blended_, casting_;
  TriangleRaster cut_, layer_;
  std::optional<TriangleRaster> sunCasters_;
  std::array<std::optional<Visibility>, 2> layers_;  ///< visibility of the current and the previous blended
                                                     ///< layer
  std::optional<ShadedTiles> tiles_;                 ///< tile lists of the current layer
  gl::Buffer through_;                               ///< fraction of light that the layers drawn so far let
                                                     ///< through, per sample
  gl::Texture throughView_;
};

}  // namespace simreel::draw
