#pragma once
#include "sim/grid/field_display.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::sim {

/// Returns the magnification of letters in charts and axes. It is also the width of thin lines in pixels.
[[nodiscard]] int letterUnit(glm::ivec2 picture);

/// Position of a field's cells in a picture.
struct FieldView {
  glm::dvec4 part{0};      ///< left, top, right and bottom edge, in whole pixels, of the part of the
                           ///< picture that the field covers
  glm::dvec2 origin{0};    ///< cell coordinates at the picture's top left corner
  glm::dvec2 perPixel{1};  ///< number of cells per pixel
};

/// Returns the margins in pixels on the left and at the bottom that axes need within the display's part of
/// the picture. They are zero if there are no axes (FieldDisplay::Axis), or if the part is too small for
/// letters.
[[nodiscard]] glm::ivec2 axesMargin(const FieldDisplay& display, glm::ivec2 picture);

/// Returns the view of a display at `seconds`, from its fit, zoom and centre. If the view does not move and
/// the magnification is an integer, cell edges lie on pixel edges.
[[nodiscard]] FieldView fieldView(const FieldDisplay& display, glm::ivec2 cells, glm::ivec2 picture,
                                  double seconds);

}  // namespace simreel::sim
