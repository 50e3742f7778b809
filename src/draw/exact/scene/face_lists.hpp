#pragma once
#include "draw/exact/scene/merged_mesh.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

namespace simreel::draw {

struct FaceListKernel;

/// Lists the triangles of a mesh that each shadow map of the lamps may show. Few triangles are visible in
/// more than two of a lamp's six faces.
class FaceLists {
 public:
  /// `lampDefines`: Lamps::shadowDefines(); if empty, only all() may be used.
  explicit FaceLists(const gl::Defines& lampDefines);

  /// Returns the number of maps that may have lists at once, with `triangles` entries each.
  static int facesAtOnce(int triangles);
  /// Lists the triangles of the maps [first, first + faces), six per lamp. The lamps must be bound.
  const TriangleLists& find(const MergedMesh& mesh, int first, int faces);
  /// Returns lists with the first `triangles` triangles of the mesh for each map. This is the conservative
  /// alternative to find().
  const TriangleLists& all(const MergedMesh& mesh, int triangles, int faces);

 private:
  void makeRoom(const MergedMesh& mesh, int faces);

  gl::Kernel<FaceListKernel> kernel_;
  gl::Buffer numbers_, counts_;
  gl::Texture numberView_;
  TriangleLists lists_;
};

}  // namespace simreel::draw
