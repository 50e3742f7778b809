#pragma once
#include "gl/buffer.hpp"
#include "gl/kernel/kernel.hpp"
#include "gl/radix_sort.hpp"
#include "gl/texture.hpp"

#include <optional>

namespace simreel::draw {

struct SolidBounds;
struct SolidKeys;
struct SolidOrder;
struct SolidNodes;

/// Triangles or balls in their order along a space-filling curve, and over them a complete binary tree of
/// boxes, made by kernels: node 1 is the root, the children of n are 2n and 2n + 1, a leaf holds two to
/// four, or one. The same bits on every machine.
class Hierarchy {
 public:
  enum class Of { triangles, balls };
  /// Where what it is made of lies, as glsl/draw/exact/rays/solids.glsl says.
  struct Solids {
    int count = 0;
    const gl::Texture* places = nullptr;
    const gl::Texture* corners = nullptr;  ///< of triangles
    const gl::Texture* words = nullptr;    ///< of triangles' vertices: the last says whose they are
    const gl::Texture* ballLooks = nullptr;
    const gl::Texture* looks = nullptr;
  };
  explicit Hierarchy(Of of) : of_(of) {}

  /// Grows the bounds (six ordered keys) by all of them.
  void growBounds(const Solids& solids, const gl::Buffer& bounds);
  /// Once the bounds of everything are there. Throws UserError(device) where the device cannot hold it.
  void build(const Solids& solids, const gl::Buffer& bounds);
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] int leaves() const { return leaves_; }
  /// Of triangles: the number that each had, in their order.
  [[nodiscard]] const gl::Texture& ids() const { return idView_; }
  [[nodiscard]] const gl::Buffer& sorted() const { return sorted_; }
  /// The same as texels, and the tree's; none where there is nothing.
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
  int room_ = 0;  ///< of the sort
  std::optional<gl::RadixSort> sort_;
  gl::Kernel<SolidBounds> bounds_;
  gl::Kernel<SolidKeys> keys_;
  gl::Kernel<SolidOrder> order_;
  gl::Kernel<SolidNodes> leafNodes_, nodes_;
  gl::Buffer sorted_, nodeBoxes_, ids_;
  gl::Texture sortedView_, nodeView_, idView_;
};

}  // namespace simreel::draw
