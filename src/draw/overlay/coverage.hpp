#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::draw {

/// How much of each pixel of a box polygons cover.
struct Coverage {
  glm::ivec2 corner{0};             ///< of the box: pixels from the picture's left and top
  glm::ivec2 size{0};               ///< of it; 0: nothing of them lies in the picture
  std::vector<std::uint8_t> share;  ///< rows from the top, 255: all of it
};

/// Of closed polygons in pixels, y down, of which none overlaps another that goes the same way round: the
/// exact area, rounded once. What lies beyond the picture is left out.
[[nodiscard]] Coverage coverageOf(std::span<const std::vector<glm::dvec2>> polygons, glm::ivec2 picture);

}  // namespace simreel::draw
