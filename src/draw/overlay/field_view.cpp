#include "draw/overlay/field_view.hpp"

#include "draw/overlay/text_boxes.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace simreel::draw {

namespace {

constexpr float reliefCells = 7.0F;  // relief height of the whole value range, in cells, for relief 1

glm::dvec2 wrapped(glm::dvec2 at, glm::dvec2 size) {
  return at - size * glm::floor(at / size);
}

}  // namespace

glm::ivec2 axesMargin(const sim::FieldDisplay& display, glm::ivec2 picture) {
  const int unit = letterUnit(picture);
  const glm::dvec2 extent = glm::dvec2(display.extent) * glm::dvec2(picture);
  if (extent.x < 160 * unit || extent.y < 100 * unit) return {0, 0};
  return {display.down ? 46 * unit : 0, display.across ? 32 * unit : 0};
}

FieldView fieldView(const sim::FieldDisplay& display, glm::ivec2 cells, glm::ivec2 picture,
                    double seconds) {
  const glm::dvec2 whole(picture);
  const glm::ivec2 margin = axesMargin(display, picture);
  const glm::dvec2 corner = glm::round(glm::dvec2(display.corner) * whole) + glm::dvec2(margin.x, 0);
  const glm::dvec2 end =
      glm::round(glm::dvec2(display.corner + display.extent) * whole) - glm::dvec2(0, margin.y);
  const glm::dvec2 extent = glm::max(end - corner, 1.0);
  const glm::dvec2 each = extent / glm::dvec2(cells);  // pixels per cell along x and y
  glm::dvec2 scale = each;
  if (display.fit == sim::FieldDisplay::Fit::contain) scale = glm::dvec2(std::min(each.x, each.y));
  if (display.fit == sim::FieldDisplay::Fit::cover) scale = glm::dvec2(std::max(each.x, each.y));
  scale *= static_cast<double>(display.zoom.at(seconds));
  const glm::dvec2 center = glm::dvec2(display.center.at(seconds)) * glm::dvec2(cells);
  FieldView view;
  view.part = {corner, corner + extent};
  view.perPixel = 1.0 / scale;
  // Pixel position of the corner of cell (0, 0).
  glm::dvec2 first = corner + 0.5 * extent - center * scale;
  if (!display.zoom.moves() && !display.center.moves())
    for (int i = 0; i < 2; ++i)
      if (std::abs(scale[i] - std::round(scale[i])) < 1e-6 && scale[i] > 0.5)
        first[i] = std::floor(first[i] + 0.5);
  view.origin = -first / scale;
  return view;
}

FieldPlace fieldPlace(const sim::Field& field, const FieldView& view, glm::ivec2 size) {
  const glm::dvec2 elements = glm::dvec2(size) / glm::dvec2(field.size);  // elements per cell
  // Integer and fractional part are separate, so that the fractional part is exact as float for fields of
  // any size.
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
