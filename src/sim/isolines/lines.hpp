#pragma once
#include "sim/grid/field_view.hpp"

#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Samples of a field on a regular grid of points.
struct IsoGrid {
  glm::ivec2 size{0};          ///< number of points along x and y
  glm::dvec2 first{0};         ///< position of the first point in the picture, in pixels
  glm::dvec2 spacing{1};       ///< distance between points in pixels
  std::vector<double> values;  ///< values with x fastest; NaN where there is no value
};

/// Line through points of the picture (in pixels, y down).
struct IsoLine {
  std::vector<glm::dvec2> points;
  bool closed = false;  ///< true if the last point is connected to the first
  int level = 0;        ///< index of the line's level
};

/// Samples the part of a field that the view shows. A magnified field is sampled about every two pixels and
/// interpolated between cell centres by cubic splines through the cell values (Catmull and Rom 1974). If
/// cells are smaller than a pixel, the samples are means of cells. `values` has one value per cell, x
/// fastest.
[[nodiscard]] IsoGrid isoGrid(std::span<const float> values, glm::ivec2 cells, const FieldView& view);

/// Returns the lines on which the samples equal one of the levels, by marching squares with linear
/// interpolation along the edges. A saddle is resolved by the mean of its corners. Lines end at missing
/// values. The order of lines and points depends only on the samples. The lines are clipped to `part`
/// (left, top, right, bottom).
[[nodiscard]] std::vector<IsoLine> isoLines(const IsoGrid& grid, std::span<const double> levels,
                                            const glm::dvec4& part);

/// Returns the part of the segment from..to that is inside a rectangle (left, top, right, bottom), as the
/// fractions of the segment at which the part starts and ends. If no part is inside, the first fraction is
/// not less than the second.
[[nodiscard]] glm::dvec2 shareWithin(glm::dvec2 from, glm::dvec2 to, const glm::dvec4& part);

/// Returns the outline of a line with this width (pixels): one polygon, or for a closed line two polygons
/// of opposite orientation. The orientation is the same for all lines.
[[nodiscard]] std::vector<std::vector<glm::dvec2>> isoStroke(const IsoLine& line, double width);

}  // namespace simreel::sim
