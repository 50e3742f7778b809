#pragma once
#include "sim/body/figure.hpp"

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// Capsule around a bone, in bone space in the bind pose.
struct BoneCapsule {
  int node = 0;
  glm::dvec3 ends[2] = {};  ///< centres of the round ends in metres
  double radius = 0;        ///< radius in metres
};

/// Maximum number of capsules per body. Only the bones that dominate the largest skin areas get a capsule.
constexpr std::size_t maxCapsules = 24;

/// Returns a capsule for each bone that dominates (has the largest weight in) at least 1/300 of the skin's
/// area. The axis runs from the bone to its child, or to the mean position of several children. For a bone
/// without children, or with children close to it, the axis extends as far as the skin that the bone
/// dominates. The axis is then shifted sideways to the centre of that skin. The radius is the mean distance
/// of the skin from the axis, without the nearest and farthest quarter of the area. Round ends that would
/// stick out of the skin are shortened.
[[nodiscard]] std::vector<BoneCapsule> fitCapsules(const Figure& figure);

}  // namespace simreel::sim
