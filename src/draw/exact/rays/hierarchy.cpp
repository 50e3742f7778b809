#include "draw/exact/rays/hierarchy.hpp"

#include "draw/exact/rays/bindings.hpp"
#include "draw/exact/reserve.hpp"
#include "draw/exact/visibility.hpp"
#include "gl/element_array.hpp"

#include <algorithm>
#include <bit>

namespace simreel::draw {

namespace {

/// Triangles that a leaf holds at least, if there are so many.
constexpr int leastOfLeaf = 2;
constexpr int boundsInvocations = 4096;
/// Of a key that sorting looks at: keys.comp.
constexpr int lowKeyBits = 12, highKeyBits = 24;

}  // namespace

gl::Program Hierarchy::made(const char* path, bool leaves) const {
  gl::Defines defines = gl::kernelDefines(false);
  if (of_ == Of::balls) defines.emplace_back("BALLS", "1");
  if (leaves) defines.emplace_back("LEAVES", "1");
  return gl::Program::compute(path, defines);
}

void Hierarchy::makePrograms() {
  if (bounds_) return;
  bounds_ = made("draw/exact/rays/bounds.comp");
  keys_ = made("draw/exact/rays/keys.comp");
  order_ = made("draw/exact/rays/order.comp");
  leafNodes_ = made("draw/exact/rays/nodes.comp", true);
  nodes_ = made("draw/exact/rays/nodes.comp");
}

void Hierarchy::bindSolids(const Solids& solids) const {
  solids.places->bind(solidPlaceUnit);
  if (solids.corners != nullptr) solids.corners->bind(solidCornerUnit);
  if (solids.words != nullptr) solids.words->bind(solidWordUnit);
  if (solids.ballLooks != nullptr) solids.ballLooks->bind(ballLookUnit);
  solids.looks->bind(rayLookUnit);
}

void Hierarchy::growBounds(const Solids& solids, const gl::Buffer& bounds) {
  if (solids.count == 0) return;
  makePrograms();
  bindSolids(solids);
  bounds.bindStorage(rayBoundsBinding);
  bounds_.set("count", solids.count);
  bounds_.set("invocations", boundsInvocations);
  bounds_.dispatch(std::min(solids.count, boundsInvocations));
}

void Hierarchy::build(const Solids& solids, const gl::Buffer& bounds) {
  count_ = solids.count;
  if (count_ == 0) return;
  makePrograms();
  const auto count = static_cast<std::size_t>(count_);
  leaves_ = static_cast<int>(std::bit_floor(static_cast<unsigned>(std::max(count_ / leastOfLeaf, 1))));
  if (room_ < count_) {
    sort_.emplace(of_ == Of::balls ? "balls that rays meet" : "triangles that rays meet", count_);
    room_ = count_;
  }
  const std::size_t texels = of_ == Of::balls ? 2 : 3;
  reserve(sorted_, sortedView_, "what rays meet", texels * count * 16, GL_RGBA32UI, 16);
  reserve(nodeBoxes_, nodeView_, "boxes of what rays meet", 2 * static_cast<std::size_t>(leaves_) * 16,
          GL_RGBA32UI, 16);
  reserve(ids_, idView_, "numbers of what rays meet", count * sizeof(GLuint), GL_R32UI, sizeof(GLuint));
  bindSolids(solids);
  bounds.bindStorage(rayBoundsBinding);
  sort_->records().bindState(outRecordBinding);
  keys_.set("count", count_);
  dispatchRows(keys_, count_);
  sort_->sort(count_, lowKeyBits, highKeyBits);

  bindSolids(solids);
  bounds.bindStorage(rayBoundsBinding);
  sort_->records().bindInput(recordUnit);
  sorted_.bindStorage(outRecordBinding);
  ids_.bindStorage(outIdBinding);
  order_.set("count", count_);
  dispatchRows(order_, count_);
  gl::barrier();

  sortedView_.bind(solidUnit);
  nodeView_.bind(solidNodeUnit);
  nodeBoxes_.bindStorage(outNodeBinding);
  for (int width = leaves_; width >= 1; width /= 2) {
    const gl::Program& program = width == leaves_ ? leafNodes_ : nodes_;
    program.set("count", count_);
    program.set("leaves", leaves_);
    program.set("width", width);
    dispatchRows(program, width);
    gl::barrier();
  }
}

void Hierarchy::bind(const gl::Program& program) const {
  const bool balls = of_ == Of::balls;
  if (count_ > 0) {
    sortedView_.bind(balls ? ballUnit : solidUnit);
    nodeView_.bind(balls ? ballNodeUnit : solidNodeUnit);
    if (!balls) idView_.bind(solidIdUnit);
  }
  program.set(balls ? "ballCount" : "solidCount", count_);
  program.set(balls ? "ballLeaves" : "solidLeaves", leaves_);
}

}  // namespace simreel::draw
