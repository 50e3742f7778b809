#pragma once
#include "sim/grid/field_view.hpp"

#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Samples of a field on a regular grid of points.
struct IsoGrid {
  glm::ivec2 size{0};          ///< number of points along x and y
  glm::dvec2 first{0};         ///< place of the first point, in pixels of the picture
  glm::dvec2 apart{1};         ///< distance between points in pixels
  std::vector<double> values;  ///< x fastest; NaN: no value
};

/// Line through points of the picture (pixels, y down).
struct IsoLine {
  std::vector<glm::dvec2> points;
  bool closed = false;  ///< true if the last point is joined to the first
  int level = 0;        ///< index of its level
};

/// Samples the part of a field that the view shows. Magnified fields are interpolated between the middles
/// of cells by cubic splines through their values (Catmull and Rom 1974), about every two pixels; of cells
/// smaller than a pixel the samples are means. `values`: one per cell, x fastest.
[[nodiscard]] IsoGrid isoGrid(std::span<const float> values, glm::ivec2 cells, const FieldView& view);

/// Returns the lines where the samples equal each level, by marching squares with linear interpolation
/// along the edges; a saddle is resolved by the mean of its corners. They end at missing values. The order
/// of lines and points depends on the samples alone. Clipped to `part` (left, top, right, bottom).
[[nodiscard]] std::vector<IsoLine> isoLines(const IsoGrid& grid, std::span<const double> levels,
                                            const glm::dvec4& part);

/// Returns the part of from..to within a rectangle (left, top, right, bottom) as two fractions; the first
/// is not less than the second if no part is within.
[[nodiscard]] glm::dvec2 shareWithin(glm::dvec2 from, glm::dvec2 to, const glm::dvec4& part);

/// Returns the outline of a line of this width (pixels): one polygon, or two of opposite orientation for a
/// closed line. All outlines have the same orientation.
[[nodiscard]] std::vector<std::vector<glm::dvec2>> isoStroke(const IsoLine& line, double width);

}  // namespace simreel::sim
