#pragma once
#include "sim/grid/field_display.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Returns the magnification of letters in charts and axes, which is also the width of thin lines (pixels).
[[nodiscard]] int letterUnit(glm::ivec2 picture);

/// Position of a field's cells in a picture.
struct FieldView {
  glm::dvec4 part{0};      ///< left, top, right, bottom of the field's part of the picture, in whole pixels
  glm::dvec2 origin{0};    ///< cell coordinates at the picture's top left corner
  glm::dvec2 perPixel{1};  ///< cells per pixel
};

/// Returns the margins (pixels) that axes take from the display's part of the picture: on the left, and at
/// the bottom. Zero without axes (FieldDisplay::Axis), or if the part is too small for letters.
[[nodiscard]] glm::ivec2 axesMargin(const FieldDisplay& display, glm::ivec2 picture);

/// Returns the view of a display at `seconds`, from its fit, zoom and centre. If the view does not move and
/// the magnification is an integer, cell edges lie on pixel edges.
[[nodiscard]] FieldView fieldView(const FieldDisplay& display, glm::ivec2 cells, glm::ivec2 picture,
                                  double seconds);

}  // namespace simreel::sim
