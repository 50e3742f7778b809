#pragma once
#include "draw/exact/instances/exact_instances.hpp"
#include "draw/exact/scene/face_lists.hpp"
#include "draw/exact/scene/merged_mesh.hpp"
#include "draw/exact/triangles/joined_surfaces.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "draw/lights/lamps.hpp"
#include "gl/buffer.hpp"

#include <optional>
#include <vector>

namespace simreel::draw {

class TransparentSurfaces;

/// Shadow maps of the lamps, six per lamp. The exact rasterizer draws each map like a picture.
class LampMaps {
 public:
  /// `sparing`: if true, each map processes only the triangles that it may show. If false, or if the GPU
  /// determines a surface's triangle count, each map processes all triangles. `together`: true to draw all
  /// maps in one dispatch (best on GPUs), false to draw them one by one. The maps are the same in all
  /// cases.
  explicit LampMaps(const Lamps& lamps, bool sparing = true, bool together = joinsSurfaces());
  [[nodiscard]] bool on() const { return count_ > 0; }
  /// Draws all maps for the last update of the lamps. `transparent`: cut-out and blended surfaces that also
  /// cast shadows; may be null. Changes the bound view block.
  void draw(const sim::Drawables& drawables, const Lamps& lamps, ExactInstances& instances,
            TransparentSurfaces* transparent = nullptr);
  /// Returns the depth keys of all maps (one atlas).
  [[nodiscard]] const Visibility& keys() const { return *keys_; }

 private:
  void drawMesh(TriangleRaster& raster, const std::vector<const sim::Surface*>& casting,
                const std::vector<MapFace>& faces, bool together);

  bool sparing_;
  bool together_;
  int count_;                   ///< number of lamps with shadows
  std::size_t viewStride_ = 0;  ///< distance (bytes) between the views of consecutive maps in `views_`
  std::optional<Visibility> keys_;
  std::optional<TriangleRaster> raster_;
  std::optional<TriangleRaster> holeRaster_;  ///< rasterizer for surfaces with holes
  std::optional<MergedMesh> mesh_;
  std::optional<FaceLists> lists_;
  gl::Buffer views_;
  gl::Buffer allViews_;  ///< the same views as in `views_`, without alignment gaps
};

}  // namespace simreel::draw
