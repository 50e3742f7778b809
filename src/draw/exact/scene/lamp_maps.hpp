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

/// Shadow maps around the lamps, six for each, drawn by the exact rasterizer: every one is seen as a
/// picture is.
class LampMaps {
 public:
  /// `sparing`: faces go through those triangles only that they may show; else, where no surface says
  /// itself how many it has, through all. `together`: all maps in one go, as cards have it best; else one
  /// by one. The maps are the same.
  explicit LampMaps(const Lamps& lamps, bool sparing = true, bool together = joinsSurfaces());
  [[nodiscard]] bool on() const { return count_ > 0; }
  /// Draws all of them for the lamps as they were updated last, with those that `apart` has taken (null:
  /// none); the view's block is bound to others
  /// afterwards.
  void draw(const sim::Drawables& drawables, const Lamps& lamps, ExactInstances& instances,
            ApartSurfaces* apart = nullptr);
  /// All of the maps, as they lie in memory.
  [[nodiscard]] const Visibility& keys() const { return *keys_; }

 private:
  void drawMesh(TriangleRaster& raster, const std::vector<const sim::Surface*>& casting,
                const std::vector<MapFace>& faces, bool together);

  bool sparing_;
  bool together_;
  int count_;  ///< lamps with shadows
  float softness_ = 0;
  std::size_t viewStride_ = 0;  ///< bytes from one map's view to the next
  std::optional<Visibility> keys_;
  std::optional<TriangleRaster> raster_;
  std::optional<TriangleRaster> holeRaster_;  ///< of surfaces with holes
  std::optional<MergedMesh> mesh_;
  std::optional<FaceLists> lists_;
  gl::Buffer views_;
  gl::Buffer allViews_;  ///< without gaps
};

}  // namespace simreel::draw
