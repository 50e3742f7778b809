#pragma once
#include "gl/context.hpp"

#include <algorithm>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Groups that share the tiles of a large thing: many on a graphics card; and so many that no invocation's
/// loops end early, which they do in silence after 65,535 turns on some drivers.
[[nodiscard]] inline unsigned partsFor(glm::ivec2 size, int samples) {
  constexpr int maxTurns = 60000;
  const int tiles = ((size.x + 15) / 8) * ((size.y + 15) / 8);
  const int each = maxTurns / (samples + 1);
  return static_cast<unsigned>(std::max(gl::softwareDriver() ? 4 : 32, (tiles + each - 1) / each));
}

}  // namespace simreel::draw
