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

class ApartSurfaces;

/// Shadow maps of the lamps, six for each. The exact rasterizer draws each map like a picture.
class LampMaps {
 public:
  /// `sparing`: each face processes only the triangles that it may show; if false, all triangles, unless
  /// the GPU determines a surface's triangle count. `together`: draws all maps in one dispatch, which is
  /// best on GPUs; else one by one. The maps are the same in all cases.
  explicit LampMaps(const Lamps& lamps, bool sparing = true, bool together = joinsSurfaces());
  [[nodiscard]] bool on() const { return count_ > 0; }
  /// Draws all maps for the last update of the lamps. `apart`: also draws its shadow-casting surfaces
  /// (null: none). Changes the bound view block.
  void draw(const sim::Drawables& drawables, const Lamps& lamps, ExactInstances& instances,
            ApartSurfaces* apart = nullptr);
  /// Returns the depth keys of all maps (one atlas).
  [[nodiscard]] const Visibility& keys() const { return *keys_; }

 private:
  void drawMesh(TriangleRaster& raster, const std::vector<const sim::Surface*>& casting,
                const std::vector<MapFace>& faces, bool together);

  bool sparing_;
  bool together_;
  int count_;  ///< number of lamps with shadows
  float softness_ = 0;
  std::size_t viewStride_ = 0;  ///< bytes between the views of two maps
  std::optional<Visibility> keys_;
  std::optional<TriangleRaster> raster_;
  std::optional<TriangleRaster> holeRaster_;  ///< rasterizer for surfaces with holes
  std::optional<MergedMesh> mesh_;
  std::optional<FaceLists> lists_;
  gl::Buffer views_;
  gl::Buffer allViews_;  ///< the same views without alignment gaps
};

}  // namespace simreel::draw
