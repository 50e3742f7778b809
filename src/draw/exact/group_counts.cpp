#include "draw/exact/group_counts.hpp"

#include "draw/exact/bindings.hpp"

namespace simreel::draw {

void GroupCounts::fill(const gl::Buffer& counts, const Order& order, const gl::Buffer& groups) const {
  counts.bindStorage(counterBinding);
  groups.bindStorage(dispatchBinding);
  program_.set("first", order.first);
  program_.set("firstCount", order.firstCount);
  program_.set("counts", order.counts);
  program_.set("skipped", order.skipped);
  program_.set("most", order.most);
  program_.set("times", order.times);
  program_.set("each", order.each);
  program_.set("parts", order.parts);
  program_.set("fewerParts", order.fewerParts);
  program_.dispatch(order.counts);
}

void GroupCounts::dispatch(const gl::Buffer& groups, std::size_t number) {
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, groups.name());
  glDispatchComputeIndirect(static_cast<GLintptr>(number * bytes));
}

}  // namespace simreel::draw
