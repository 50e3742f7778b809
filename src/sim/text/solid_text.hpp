#pragma once
#include "sim/mesh/file/mesh_file.hpp"
#include "sim/text/letters/font.hpp"

#include <vector>

namespace simreel::sim {

/// Piece of an outline's interior, bounded by two heights and by one straight line on each side.
struct Trapezoid {
  double bottom, top;
  double bottomLeft, bottomRight, topLeft, topRight;
};
/// Divides the filled area into trapezoids that do not overlap. Trapezoids above each other touch at common
/// heights, where coincident corners have identical coordinates.
[[nodiscard]] std::vector<Trapezoid> trapezoids(const TextOutlines& outlines);

/// Returns a solid of the outlines that extends from z = -depth / 2 to depth / 2 (metres); `height` is the
/// length of one unit of the outlines in metres. If `depth` is 0, it has only a front. Triangles meet in
/// whole edges. Texture coordinates span the bounding box. The mesh is empty if there are no outlines.
[[nodiscard]] Mesh solidText(const TextOutlines& outlines, double height, double depth);

}  // namespace simreel::sim
