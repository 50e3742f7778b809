#pragma once
#include "sim/core/drawable.hpp"
#include "sim/grid/field_display.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

/// Where the cells of a field lie in a picture.
struct FieldView {
  glm::dvec4 part{0};      ///< left, top, right, bottom of its part of the picture, whole pixels
  glm::dvec2 origin{0};    ///< cell coordinates of the picture's top left corner
  glm::dvec2 perPixel{1};  ///< cells a pixel
};

/// Pixels that the scales of a display take from its part: at the left, and below it. As FieldDisplay::Axis
/// says; zero where there are none or the part is too small for letters.
[[nodiscard]] glm::ivec2 axesMargin(const sim::FieldDisplay& display, glm::ivec2 picture);

/// Fit, zoom and centre of a display at `seconds`. A field that holds still at a whole magnification has
/// the edges of its cells on edges of pixels.
[[nodiscard]] FieldView fieldView(const sim::FieldDisplay& display, glm::ivec2 cells, glm::ivec2 picture,
                                  double seconds);

/// A view as shaders get it (glsl/draw/overlay/field_view.glsl): in elements, which are cells or the texels
/// of a texture of `size` that covers the field. Pixel p covers the elements from base + start + perPixel p
/// to + perPixel (p + 1).
struct FieldPlace {
  glm::ivec2 size{0}, base{0};
  glm::vec2 start{0}, perPixel{1};
  glm::vec2 slope{0};  ///< height of the whole range in elements
};
[[nodiscard]] FieldPlace fieldPlace(const sim::Field& field, const FieldView& view, glm::ivec2 size);

/// 1 / (last - first value of a field's range), as shaders get it: finite, and no subnormal number.
[[nodiscard]] float rangeFactor(glm::vec2 range);

}  // namespace simreel::draw
