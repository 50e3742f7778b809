#pragma once
#include "sim/core/simulation.hpp"

#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::frame {

/// One closed contour: its level and its points in sequence. Collinear points are removed. The loop starts
/// at the point with the lowest index in ContourLines.
struct ContourLoop {
  int level = 1;
  std::vector<glm::vec2> points;
};
[[nodiscard]] std::vector<ContourLoop> contourLoops(const sim::ContourLines& lines);

/// Returns the contours as SVG. Each level has one path with all its loops, filled by the even-odd rule.
/// One SVG unit is one cell, and y grows downwards. `size`: size of the field in cells.
[[nodiscard]] std::string encodeSvg(const sim::ContourLines& lines, glm::ivec2 size,
                                    std::span<const std::string> comments);

/// Returns the contours as a GeoJSON FeatureCollection (RFC 7946). Each loop becomes a LineString whose
/// last point equals the first, with the property "level". Coordinates are in cells. Because maps have
/// north at the top, y points upwards: cell (x, y) is at [x, -y]. `path` (in cells; may be empty) becomes a
/// LineString with the property "path". Each room becomes a Point at its centre with the properties "room"
/// (number from 1), "cells" and "area" (m^2).
[[nodiscard]] std::string encodeGeoJson(const sim::ContourLines& lines, std::span<const glm::vec2> path,
                                        std::span<const std::string> comments);

}  // namespace simreel::frame
