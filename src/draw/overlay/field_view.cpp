#include "draw/overlay/field_view.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace simreel::draw {

namespace {

constexpr float reliefCells = 7.0F;  // height (cells) of the relief of the full value range if the relief
                                     // is 1

glm::dvec2 wrapped(glm::dvec2 at, glm::dvec2 size) {
  return at - size * glm::floor(at / size);
}

}  // namespace

FieldPlace fieldPlace(const sim::Field& field, const FieldView& view, glm::ivec2 size) {
  const glm::dvec2 elements = glm::dvec2(size) / glm::dvec2(field.size);  // elements per cell
  // The integer and the fractional part are stored separately, so that the fractional part is precise as a
  // float even for large fields.
  glm::dvec2 first = glm::clamp(view.origin * elements, -1e9, 1e9);
  if (field.display->tiled) first = wrapped(first, glm::dvec2(size));
  const glm::dvec2 base = glm::floor(first);
  return {.size = size,
          .base = glm::ivec2(base),
          .start = glm::vec2(first - base),
          .perPixel = glm::vec2(view.perPixel * elements),
          .slope = field.display->relief * reliefCells * glm::vec2(elements)};
}

float rangeFactor(glm::vec2 range) {
  const float span = range.y - range.x;
  const float size = std::clamp(std::abs(span), 1e-18F, 1e18F);
  return span < 0 ? -1 / size : 1 / size;
}

}  // namespace simreel::draw
