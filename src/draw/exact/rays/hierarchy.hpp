#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/sort/radix_sort.hpp"
#include "gl/texture.hpp"

#include <optional>

namespace simreel::draw {

struct SolidBounds;
struct SolidKeys;
struct SolidOrder;
struct SolidNodes;

/// Sorts triangles or balls along a space-filling curve and builds a complete binary tree of bounding
/// boxes, with kernels. Node 1 is the root. The children of node n are 2n and 2n + 1. A leaf holds two to
/// four items, or one if the tree has only one item. The bits are the same on every machine.
class Hierarchy {
 public:
  enum class Of { triangles, balls };
  /// Input buffers of the items, as in glsl/draw/exact/rays/solids.glsl.
  struct Solids {
    int count = 0;
    const gl::Texture* places = nullptr;
    const gl::Texture* corners = nullptr;  ///< for triangles only: indices of the corners
    const gl::Texture* words = nullptr;    ///< vertex data of triangles; the last word of each vertex is
                                           ///< the owner, an index of the material table
    const gl::Texture* ballLooks = nullptr;
    const gl::Texture* materials = nullptr;
  };
  explicit Hierarchy(Of of) : of_(of) {}

  /// Extends the bounds (six ordered keys) so that they contain all items.
  void growBounds(const Solids& solids, const gl::Buffer& bounds);
  /// Builds the tree. Call when the bounds of the whole scene are complete. Throws UserError(device) if the
  /// tree exceeds a device limit.
  void build(const Solids& solids, const gl::Buffer& bounds);
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] int leaves() const { return leaves_; }
  /// Triangles only: returns the original index of each triangle, in sorted order.
  [[nodiscard]] const gl::Texture& ids() const { return idView_; }
  [[nodiscard]] const gl::Buffer& sorted() const { return sorted_; }
  /// Return texel views of the sorted items and of the tree, or empty resources if there are no items.
  [[nodiscard]] gl::Resource sortedTexels() const {
    return count_ > 0 ? gl::Resource(sortedView_) : gl::Resource();
  }
  [[nodiscard]] gl::Resource nodeTexels() const {
    return count_ > 0 ? gl::Resource(nodeView_) : gl::Resource();
  }
  [[nodiscard]] const gl::Buffer& nodes() const { return nodeBoxes_; }

 private:
  void makeKernels();

  Of of_;
  int count_ = 0, leaves_ = 1;
  int room_ = 0;  ///< capacity of the sort buffers (items)
  std::optional<gl::RadixSort> sort_;
  gl::Kernel<SolidBounds> bounds_;
  gl::Kernel<SolidKeys> keys_;
  gl::Kernel<SolidOrder> order_;
  gl::Kernel<SolidNodes> leafNodes_, nodes_;
  gl::Buffer sorted_, nodeBoxes_, ids_;
  gl::Texture sortedView_, nodeView_, idView_;
};

}  // namespace simreel::draw
