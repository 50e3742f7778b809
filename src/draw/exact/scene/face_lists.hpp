#pragma once
#include "draw/exact/scene/merged_mesh.hpp"
#include "draw/exact/triangles/triangle_raster.hpp"
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"

namespace simreel::draw {

struct FaceListKernel;

/// Which of a mesh's triangles each of some lamps' shadow maps may show: few are seen by more than two of
/// the six faces around a lamp.
class FaceLists {
 public:
  /// `lampDefines`: Lamps::shadowDefines(); empty: for all() only.
  explicit FaceLists(const gl::Defines& lampDefines);

  /// How many maps may have lists at once, of `triangles` each.
  static int facesAtOnce(int triangles);
  /// Finds those of the maps `first` to before `first + faces` (six of each lamp in turn). The lamps are
  /// bound.
  const TriangleLists& find(const MergedMesh& mesh, int first, int faces);
  /// The first `triangles` of the mesh for each: what find() spares its users, and never less.
  const TriangleLists& all(const MergedMesh& mesh, int triangles, int faces);

 private:
  void makeRoom(const MergedMesh& mesh, int faces);

  gl::Kernel<FaceListKernel> kernel_;
  gl::Buffer numbers_, counts_;
  gl::Texture numberView_;
  TriangleLists lists_;
};

}  // namespace simreel::draw
