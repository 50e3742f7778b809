#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <vector>

namespace simreel::draw {

struct MergeKernel;

/// Merges surfaces into one mesh in world space that is drawn several times. On software drivers a separate
/// dispatch for each of many small surfaces costs more than their triangles.
class MergedMesh {
 public:
  MergedMesh();
  /// Merges the surfaces. The order of the triangles is arbitrary. The uniform blocks of deformations need
  /// not be bound. Throws UserError(device) if the indices exceed the supported range.
  void merge(const std::vector<const sim::Surface*>& surfaces);
  /// Returns the vertex positions in world space (m), RGBA32F.
  [[nodiscard]] const gl::Texture& places() const { return placesView_; }
  /// Returns the vertex indices, R32UI, three per triangle.
  [[nodiscard]] const gl::Texture& indexView() const { return indicesView_; }
  /// Returns the buffer with the number of indices.
  [[nodiscard]] const gl::Buffer& count() const { return count_; }
  [[nodiscard]] int maxTriangles() const { return maxTriangles_; }

 private:
  gl::Kernels<MergeKernel> kernels_;
  gl::Buffer places_, indices_, count_;
  gl::Texture placesView_, indicesView_;
  int maxTriangles_ = 0;
};

}  // namespace simreel::draw
