#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// For each pixel in a box, the area that polygons cover.
struct Coverage {
  glm::ivec2 corner{0};             ///< top left pixel of the box in the picture
  glm::ivec2 size{0};               ///< size of the box; 0 if the polygons do not touch the picture
  std::vector<std::uint8_t> share;  ///< coverage of each pixel, row by row from the top; 255: fully covered
};

/// Returns the area of each pixel that closed polygons (pixels, y down) cover. The exact area is rounded
/// only once. Polygons of the same orientation must not overlap. Parts outside the picture are ignored.
[[nodiscard]] Coverage coverageOf(std::span<const std::vector<glm::dvec2>> polygons, glm::ivec2 picture);

}  // namespace simreel::draw
