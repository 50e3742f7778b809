#pragma once
#include "gl/context.hpp"

namespace simreel::draw {

/// Pixels, one below the other, that an invocation does in a row, 8 at most: groups of software drivers
/// begin and end once for each vector of lanes, and read uniforms there.
[[nodiscard]] inline int rowsAtOnce() {
  return gl::softwareDriver() ? 8 : 1;
}

}  // namespace simreel::draw
