#pragma once
#include "sim/core/simulation.hpp"

#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::frame {

/// Contours as closed lines: of each loop its level and its points in order, those on a straight line left
/// out, from the lowest point on.
struct ContourLoop {
  int level = 1;
  std::vector<glm::vec2> points;
};
[[nodiscard]] std::vector<ContourLoop> contourLoops(const sim::ContourLines& lines);

/// A picture of them: a path for each level with all its loops, filled by the even-odd rule; cells are
/// units, y grows downwards. `size` of the field in cells.
[[nodiscard]] std::string encodeSvg(const sim::ContourLines& lines, glm::ivec2 size,
                                    std::span<const std::string> comments);

/// A FeatureCollection (RFC 7946) with a LineString for each loop, whose first point is repeated at its
/// end, and with the property "level". Coordinates are cells with y upwards, for maps have north above:
/// cell (x, y) is at [x, -y]. `path`: in cells, a LineString with the property "path"; empty: none. A Point
/// at the centre of each room has its number "room" from 1, its "cells" and its "area" in m^2.
[[nodiscard]] std::string encodeGeoJson(const sim::ContourLines& lines, std::span<const glm::vec2> path,
                                        std::span<const std::string> comments);

}  // namespace simreel::frame
