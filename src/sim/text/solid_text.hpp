#pragma once
#include "sim/mesh/file/mesh_file.hpp"
#include "sim/text/letters/font.hpp"

#include <vector>

namespace simreel::sim {

/// A part of what outlines fill: between two heights, left and right a straight line each.
struct Trapezoid {
  double bottom, top;
  double bottomLeft, bottomRight, topLeft, topRight;
};
/// All that they fill, in parts that do not overlap. Those that lie above one another meet along whole
/// heights, of which the corners are the same numbers where they are the same points.
[[nodiscard]] std::vector<Trapezoid> trapezoids(const TextOutlines& outlines);

/// A body `depth` m thick with these outlines, `height` m a unit of them, from z = -depth / 2 to depth / 2;
/// of depth 0 its front alone. Triangles meet in whole edges. Texture coordinates lie over the box around
/// it. Empty without outlines.
[[nodiscard]] Mesh solidText(const TextOutlines& outlines, double height, double depth);

}  // namespace simreel::sim
