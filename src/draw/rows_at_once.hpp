#pragma once
#include "gl/context.hpp"

namespace simreel::draw {

/// Returns the number of pixels, one below the other, that an invocation handles (at most 8). More than one
/// on software drivers, because their workgroups have a fixed cost per vector of lanes, in which they also
/// read uniforms.
[[nodiscard]] inline int rowsAtOnce() {
  return gl::softwareDriver() ? 8 : 1;
}

}  // namespace simreel::draw
