#pragma once
#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "gl/radix_sort.hpp"
#include "gl/texture.hpp"

#include <optional>

namespace simreel::draw {

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
  /// For kernels that include draw/exact/rays/traverse.glsl or found_facet.glsl.
  void bind(const gl::Program& program) const;
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] int leaves() const { return leaves_; }
  /// Of triangles: the number that each had, in their order.
  [[nodiscard]] const gl::Texture& ids() const { return idView_; }
  [[nodiscard]] const gl::Buffer& sorted() const { return sorted_; }
  [[nodiscard]] const gl::Buffer& nodes() const { return nodeBoxes_; }

 private:
  [[nodiscard]] gl::Program made(const char* path, bool leaves = false) const;
  void bindSolids(const Solids& solids) const;
  void makePrograms();

  Of of_;
  int count_ = 0, leaves_ = 1;
  int room_ = 0;  ///< of the sort
  std::optional<gl::RadixSort> sort_;
  gl::Program bounds_, keys_, order_, leafNodes_, nodes_;
  gl::Buffer sorted_, nodeBoxes_, ids_;
  gl::Texture sortedView_, nodeView_, idView_;
};

}  // namespace simreel::draw
