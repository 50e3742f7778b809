#pragma once
#include "gl/context.hpp"

#include <algorithm>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Groups that share the tiles of a large thing so that no invocation's loops end early, which they do in
/// silence after 65,535 turns on some drivers.
[[nodiscard]] inline unsigned leastParts(glm::ivec2 size, int samples) {
  constexpr int maxTurns = 60000;
  const int tiles = ((size.x + 15) / 8) * ((size.y + 15) / 8);
  const int each = maxTurns / (samples + 1);
  return static_cast<unsigned>((tiles + each - 1) / each);
}

/// The same, and many on a graphics card.
[[nodiscard]] inline unsigned partsFor(glm::ivec2 size, int samples) {
  return std::max(gl::softwareDriver() ? 4U : 32U, leastParts(size, samples));
}

}  // namespace simreel::draw
