#pragma once
#include "sim/body/figure.hpp"

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

namespace simreel::sim {

/// A capsule around a bone, at bind, in the bone's own space.
struct BoneCapsule {
  int node = 0;
  glm::dvec3 ends[2] = {};  ///< m, centres of its round ends
  double radius = 0;        ///< m
};

/// Most capsules of a body: those of the bones with the most skin.
constexpr std::size_t maxCapsules = 24;

/// A capsule for each bone that dominates (has the greatest weight) a three-hundredth of the skin or more.
/// Its axis goes from the bone to its child, or to the middle of several, or, of a bone without children or
/// whose children are beside it, as far as its skin reaches; it is moved sideways into the middle of that.
/// The radius is the mean distance of the skin from it, the nearest and the farthest quarter of its area
/// left out. Round ends that would stand out of the skin are drawn in.
[[nodiscard]] std::vector<BoneCapsule> fitCapsules(const Figure& figure);

}  // namespace simreel::sim
