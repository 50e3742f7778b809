#pragma once
#include "sim/core/drawable.hpp"
#include "sim/grid/field_view.hpp"

#include <glm/vec2.hpp>

namespace simreel::draw {

using sim::axesMargin;
using sim::FieldView;
using sim::fieldView;

/// The view of a field as uniforms (glsl/draw/overlay/field_view.glsl). Lengths are in elements. An element
/// is a cell of the field, or a texel of a texture of `size` that covers the field. Pixel p covers the
/// elements from base + start + perPixel p to base + start + perPixel (p + 1).
struct FieldPlace {
  glm::ivec2 size{0}, base{0};
  glm::vec2 start{0}, perPixel{1};
  glm::vec2 slope{0};  ///< relief height of the field's full value range, in elements
};
[[nodiscard]] FieldPlace fieldPlace(const sim::Field& field, const FieldView& view, glm::ivec2 size);

/// Returns 1 / (last - first), where `range` holds the first and the last value of a field's range. The
/// result is limited so that it is finite and not subnormal.
[[nodiscard]] float rangeFactor(glm::vec2 range);

}  // namespace simreel::draw
