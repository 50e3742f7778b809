#pragma once
#include "draw/exact/surface/surface_shading.hpp"
#include "draw/exact/tiles/shaded_tiles.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "draw/exact/visibility.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <optional>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

struct KeepLightKernel;

/// Draws surfaces of glass (with a transmission) over the finished light of everything else, without rays.
/// The layers of each sample are found one by one from the nearest, like those of blended surfaces
/// (TransparentSurfaces). The first two layers are usually the front and the back of a solid, the next two
/// those of the solid behind it. Further layers are not drawn.
class GlassSurfaces {
 public:
  /// A pair of layers, from the nearest.
  enum class Pair { near, far };
  /// `band`: size (pixels) of the bands of visibility. `parallel`: as in SampleKind.
  GlassSurfaces(glm::ivec2 size, glm::ivec2 band, int samples, SurfaceShading& shading, bool parallel);

  /// Moves the surfaces of glass from `surfaces` into this object.
  void extractFrom(std::vector<sim::Surface>& surfaces);
  [[nodiscard]] bool any() const { return !surfaces_.empty(); }
  /// Draws a pair of layers in front of `picture` over the light in `sums`, the farther one first. `light`
  /// holds the inputs of kernels that add light to `sums`. The inputs of one layer in `look` are set here.
  void add(Pair pair, const Visibility& picture, const SceneLight& light, const gl::Texture& sums,
           GlassLook look);

 private:
  struct Layer {
    Visibility visibility;
    ShadedTiles tiles;
  };
  void makeRoom();
  [[nodiscard]] int find(int maximum, const Visibility& picture, const gl::Texture& sums);
  void keep(const gl::Texture& sums) const;

  glm::ivec2 size_, band_;
  int samples_;
  bool parallel_;
  SurfaceShading& shading_;
  std::vector<sim::Surface> surfaces_;
  TriangleRaster raster_;
  std::vector<Layer> layers_;
  gl::Texture behind_;  ///< light of the picture behind the layer that is being drawn
  std::optional<gl::Kernel<KeepLightKernel>> keep_;
};

}  // namespace simreel::draw
