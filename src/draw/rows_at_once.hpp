#pragma once
#include "gl/context.hpp"

namespace simreel::draw {

/// Returns the number of vertically adjacent pixels that an invocation handles (at most 8). The number is
/// above 1 on software drivers, whose workgroups have a fixed cost per vector of lanes, for example to read
/// uniforms.
[[nodiscard]] inline int rowsAtOnce() {
  return gl::softwareDriver() ? 8 : 1;
}

}  // namespace simreel::draw
