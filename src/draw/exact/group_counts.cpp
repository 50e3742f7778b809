#include "draw/exact/group_counts.hpp"

#include "draw/exact/bindings.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"

#include <algorithm>

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

void GroupCounts::dispatch(const gl::Program& program, const gl::Buffer& groups, std::size_t number) {
  program.dispatchIndirect(groups, number * bytes);
}

void GroupCounts::prepareLists(const gl::Buffer& counts, const Order& order,
                               const gl::Buffer& groups) const {
  gl::barrier();
  if (!gl::softwareDriver()) return;
  fill(counts, order, groups);
  gl::barrier();
  glMemoryBarrier(GL_COMMAND_BARRIER_BIT);
}

void GroupCounts::dispatchList(const gl::Program& program, const gl::Buffer& groups, std::size_t number,
                               unsigned parts) {
  if (!gl::softwareDriver()) return dispatchFixed(program, parts);
  dispatch(program, groups, number);
}

void GroupCounts::dispatchFixed(const gl::Program& program, unsigned parts) {
  constexpr unsigned groups = 2048;  // a card's processors hold about as many at a time
  program.dispatchGroups(gl::softwareDriver() ? 16U : std::max(groups / parts, 1U), 1, parts);
}

}  // namespace simreel::draw
