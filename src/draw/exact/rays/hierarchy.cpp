#include "draw/exact/rays/hierarchy.hpp"

#include "draw/exact/reserve.hpp"
#include "draw/exact/visibility.hpp"
#include "draw/surface_fields.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <bit>

namespace simreel::draw {

/// Uniforms, buffers and textures that draw/exact/rays/solids.glsl declares.
struct SolidPlaces {
  gl::In<"places"> places;
  gl::In<"corners"> corners;
};

struct SolidBounds {
  static constexpr auto file = "draw/exact/rays/bounds.comp";
  struct Variant {
    gl::Flag<"BALLS"> balls;
  };
  SolidPlaces solids;
  gl::Shared<"BoundsBlock"> bounds;
  gl::Uniform<"count", int> count;
  gl::Uniform<"invocations", int> invocations;
};

struct SolidKeys {
  static constexpr auto file = "draw/exact/rays/keys.comp";
  using Variant = SolidBounds::Variant;
  SolidPlaces solids;
  gl::In<"BoundsBlock"> bounds;
  gl::Uniform<"count", int> count;
  gl::Out<"records"> records;
};

struct SolidOrder {
  static constexpr auto file = "draw/exact/rays/order.comp";
  using Variant = SolidBounds::Variant;
  gl::In<"records"> records;
  SolidPlaces solids;
  gl::In<"BoundsBlock"> bounds;
  gl::In<"vertexWords"> words;
  gl::In<"ballLooks"> ballLooks;
  gl::In<"materials"> materials;
  gl::Uniform<"count", int> count;
  gl::Out<"SortedBlock"> sorted;
  gl::Out<"IdBlock"> ids;
};

struct SolidNodes {
  static constexpr auto file = "draw/exact/rays/nodes.comp";
  struct Variant {
    gl::Flag<"BALLS"> balls;
    gl::Flag<"LEAVES"> leaves;
  };
  gl::In<"sorted"> sorted;
  gl::In<"children"> children;
  gl::Uniform<"count", int> count;
  gl::Uniform<"leaves", int> leaves;
  gl::Uniform<"width", int> width;
  gl::Out<"NodeBlock"> nodes;
};

namespace {

/// Min number of items per leaf. A tree with fewer items has one smaller leaf.
constexpr int minOfLeaf = 2;
constexpr int boundsInvocations = 4096;
/// Number of significant key bits in the first (low) and in the second (high) word of a sort record, as in
/// keys.comp.
constexpr int lowKeyBits = 12, highKeyBits = 24;

SolidPlaces placesOf(const Hierarchy::Solids& solids) {
  return {.places = *solids.places, .corners = orNone(solids.corners)};
}

}  // namespace

void Hierarchy::makeKernels() {
  if (bounds_) return;
  const gl::Defines defines = gl::kernelDefines(false);
  const bool balls = of_ == Of::balls;
  bounds_ = gl::Kernel<SolidBounds>(defines, {.balls = balls});
  keys_ = gl::Kernel<SolidKeys>(defines, {.balls = balls});
  order_ = gl::Kernel<SolidOrder>(defines, {.balls = balls});
  leafNodes_ = gl::Kernel<SolidNodes>(defines, {.balls = balls, .leaves = true});
  nodes_ = gl::Kernel<SolidNodes>(defines, {.balls = balls, .leaves = false});
}

void Hierarchy::growBounds(const Solids& solids, const gl::Buffer& bounds) {
  if (solids.count == 0) return;
  makeKernels();
  bounds_.dispatch(std::min(solids.count, boundsInvocations), {.solids = placesOf(solids),
                                                               .bounds = bounds,
                                                               .count = solids.count,
                                                               .invocations = boundsInvocations});
}

void Hierarchy::build(const Solids& solids, const gl::Buffer& bounds) {
  count_ = solids.count;
  if (count_ == 0) return;
  makeKernels();
  const auto count = static_cast<std::size_t>(count_);
  leaves_ = static_cast<int>(std::bit_floor(static_cast<unsigned>(std::max(count_ / minOfLeaf, 1))));
  if (room_ < count_) {
    sort_.emplace(of_ == Of::balls ? "balls that rays meet" : "triangles that rays meet", count_);
    room_ = count_;
  }
  const std::size_t texels = of_ == Of::balls ? 2 : 3;
  reserve(sorted_, sortedView_, "what rays meet", texels * count * 16, GL_RGBA32UI, 16);
  reserve(nodeBoxes_, nodeView_, "boxes of what rays meet", 2 * static_cast<std::size_t>(leaves_) * 16,
          GL_RGBA32UI, 16);
  reserve(ids_, idView_, "numbers of what rays meet", count * sizeof(GLuint), GL_R32UI, sizeof(GLuint));
  keys_.dispatch(
      inRows(count_),
      {.solids = placesOf(solids), .bounds = bounds, .count = count_, .records = sort_->records()});
  sort_->sort(count_, lowKeyBits, highKeyBits);
  order_.dispatch(inRows(count_), {.records = sort_->records(),
                                   .solids = placesOf(solids),
                                   .bounds = bounds,
                                   .words = orNone(solids.words),
                                   .ballLooks = orNone(solids.ballLooks),
                                   .materials = orNone(solids.materials),
                                   .count = count_,
                                   .sorted = sorted_,
                                   .ids = ids_});
  for (int width = leaves_; width >= 1; width /= 2)
    (width == leaves_ ? leafNodes_ : nodes_)
        .dispatch(inRows(width), {.sorted = sortedView_,
                                  .children = nodeView_,
                                  .count = count_,
                                  .leaves = leaves_,
                                  .width = width,
                                  .nodes = nodeBoxes_});
}

}  // namespace simreel::draw
