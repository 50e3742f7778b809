#include "draw/exact/group_counts.hpp"

#include <algorithm>

namespace simreel::draw {

void GroupCounts::fill(const gl::Buffer& counts, const CountConversion& order,
                       const gl::Buffer& groups) const {
  kernel_.dispatch(order.counts.value, {.order = order, .counters = counts, .groups = groups});
}

void GroupCounts::prepareLists(const gl::Buffer& counts, const CountConversion& order,
                               const gl::Buffer& groups) const {
  if (gl::softwareDriver()) fill(counts, order, groups);
}

unsigned GroupCounts::fixedGroups(unsigned parts) {
  constexpr unsigned groups = 2048;  // approximate number of workgroups that a GPU runs at the same time
  return gl::softwareDriver() ? 16U : std::max(groups / parts, 1U);
}

}  // namespace simreel::draw
