#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/texture.hpp"
#include "sim/core/drawable.hpp"

#include <vector>

namespace simreel::draw {

struct MergeKernel;

/// Surfaces as one in world space, for what draws them many times: a dispatch for each of many small ones
/// costs software drivers more than their triangles.
class MergedMesh {
 public:
  MergedMesh();
  /// Their triangles in any order. The deformations' blocks need not be bound. Throws UserError(device)
  /// where there are more than numbers.
  void merge(const std::vector<const sim::Surface*>& surfaces);
  [[nodiscard]] const gl::Texture& places() const { return placesView_; }  ///< m, RGBA32F
  [[nodiscard]] const gl::Texture& indexView() const {
    return indicesView_;
  }                                                                 ///< R32UI, 3 of each triangle
  [[nodiscard]] const gl::Buffer& count() const { return count_; }  ///< indices that there are
  [[nodiscard]] int maxTriangles() const { return maxTriangles_; }

 private:
  gl::Kernels<MergeKernel> kernels_;
  gl::Buffer places_, indices_, count_;
  gl::Texture placesView_, indicesView_;
  int maxTriangles_ = 0;
};

}  // namespace simreel::draw
