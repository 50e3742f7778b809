#pragma once
#include "gl/context.hpp"

#include <algorithm>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// Returns the min number of workgroups that share the tiles of a large primitive. With fewer workgroups, a
/// loop could exceed 65,535 iterations, after which some drivers silently end it. `cuts`: the primitive has
/// holes, and each sample of a pixel takes up to eight iterations (glsl/draw/exact/triangles/cutout.glsl).
[[nodiscard]] inline unsigned minWorkgroups(glm::ivec2 size, int samples, bool cuts = false) {
  constexpr int maxTurns = 60000;
  const int tiles = ((size.x + 15) / 8) * ((size.y + 15) / 8);
  const int each = maxTurns / (cuts ? 8 * samples + 2 : samples + 1);
  return static_cast<unsigned>((tiles + each - 1) / each);
}

/// Returns the number of workgroups that share the tiles of a large primitive. This is minWorkgroups(), but
/// at least 4 on software drivers and 32 on GPUs.
[[nodiscard]] inline unsigned workgroupsFor(glm::ivec2 size, int samples, bool cuts = false) {
  return std::max(gl::softwareDriver() ? 4U : 32U, minWorkgroups(size, samples, cuts));
}

}  // namespace simreel::draw
