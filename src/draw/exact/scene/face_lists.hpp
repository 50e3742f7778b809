#pragma once
#include "draw/exact/scene/merged_mesh.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

namespace simreel::draw {

struct FaceListKernel;

/// Lists, for each shadow map of the lamps, the triangles that the map may show. Few triangles are visible
/// in more than two of a lamp's six maps.
class FaceLists {
 public:
  /// `lampDefines`: result of Lamps::shadowDefines(). If it is empty, only all() may be called.
  explicit FaceLists(const gl::Defines& lampDefines);

  /// Returns the number of maps that can have lists at the same time, with `triangles` entries per list.
  static int facesAtOnce(int triangles);
  /// Lists the triangles of the maps from `first` to first + faces - 1. Each lamp has six maps. The lamps
  /// must be bound.
  const TriangleLists& find(const MergedMesh& mesh, int first, int faces);
  /// Returns lists that contain the first `triangles` triangles of the mesh for every map. They can replace
  /// the result of find(), because extra triangles do not change the maps.
  const TriangleLists& all(const MergedMesh& mesh, int triangles, int faces);

 private:
  void makeRoom(const MergedMesh& mesh, int faces);

  gl::Kernel<FaceListKernel> kernel_;
  gl::Buffer numbers_, counts_;
  gl::Texture numberView_;
  TriangleLists lists_;
};

}  // namespace simreel::draw
