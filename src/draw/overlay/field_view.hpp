#pragma once
#include "sim/core/drawable.hpp"
#include "sim/grid/field_display.hpp"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

/// Position of a field's cells in a picture.
struct FieldView {
  glm::dvec4 part{0};      ///< left, top, right, bottom of the field's part of the picture, in whole pixels
  glm::dvec2 origin{0};    ///< cell coordinates at the picture's top left corner
  glm::dvec2 perPixel{1};  ///< cells per pixel
};

/// Returns the margins (pixels) that axes take from the display's part of the picture: on the left, and at
/// the bottom. Zero without axes (FieldDisplay::Axis), or if the part is too small for letters.
[[nodiscard]] glm::ivec2 axesMargin(const sim::FieldDisplay& display, glm::ivec2 picture);

/// Returns the view of a display at `seconds`, from its fit, zoom and centre. If the view does not move and
/// the magnification is an integer, cell edges lie on pixel edges.
[[nodiscard]] FieldView fieldView(const sim::FieldDisplay& display, glm::ivec2 cells, glm::ivec2 picture,
                                  double seconds);

/// The view as uniforms (glsl/draw/overlay/field_view.glsl), in elements: cells, or texels of a texture of
/// `size` that covers the field. Pixel p covers the elements from base + start + perPixel p to base + start
/// + perPixel (p + 1).
struct FieldPlace {
  glm::ivec2 size{0}, base{0};
  glm::vec2 start{0}, perPixel{1};
  glm::vec2 slope{0};  ///< relief height of the whole value range, in elements
};
[[nodiscard]] FieldPlace fieldPlace(const sim::Field& field, const FieldView& view, glm::ivec2 size);

/// Returns 1 / (last - first value of a field's range), limited so that it is finite and not subnormal.
[[nodiscard]] float rangeFactor(glm::vec2 range);

}  // namespace simreel::draw
