#include "sim/grid/field_view.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

namespace simreel::sim {

int letterUnit(glm::ivec2 picture) {
  return std::max(1, static_cast<int>(std::lround(static_cast<float>(picture.y) / 400.0F)));
}

glm::ivec2 axesMargin(const FieldDisplay& display, glm::ivec2 picture) {
  const int unit = letterUnit(picture);
  const glm::dvec2 extent = glm::dvec2(display.extent) * glm::dvec2(picture);
  if (extent.x < 160 * unit || extent.y < 100 * unit) return {0, 0};
  return {display.down ? 46 * unit : 0, display.across ? 32 * unit : 0};
}

FieldView fieldView(const FieldDisplay& display, glm::ivec2 cells, glm::ivec2 picture, double seconds) {
  const glm::dvec2 whole(picture);
  const glm::ivec2 margin = axesMargin(display, picture);
  const glm::dvec2 corner = glm::round(glm::dvec2(display.corner) * whole) + glm::dvec2(margin.x, 0);
  const glm::dvec2 end =
      glm::round(glm::dvec2(display.corner + display.extent) * whole) - glm::dvec2(0, margin.y);
  const glm::dvec2 extent = glm::max(end - corner, 1.0);
  glm::dvec2 free = extent;  // size in pixels of the area that the field may fill
  if (display.fit == FieldDisplay::Fit::contain)
    free = glm::max(extent - glm::round(glm::dvec2(display.room) * whole), 1.0);
  const glm::dvec2 each = free / glm::dvec2(cells);  // pixels per cell along x and y
  glm::dvec2 scale = each;
  if (display.fit == FieldDisplay::Fit::contain) scale = glm::dvec2(std::min(each.x, each.y));
  if (display.fit == FieldDisplay::Fit::cover) scale = glm::dvec2(std::max(each.x, each.y));
  scale *= static_cast<double>(display.zoom.at(seconds));
  const glm::dvec2 center = glm::dvec2(display.center.at(seconds)) * glm::dvec2(cells);
  FieldView view;
  view.part = {corner, corner + extent};
  view.perPixel = 1.0 / scale;
  // Pixel position of the corner of cell (0, 0). It is rounded if the view does not move and the
  // magnification is an integer.
  glm::dvec2 first = corner + 0.5 * free - center * scale;
  if (!display.zoom.moves() && !display.center.moves())
    for (int i = 0; i < 2; ++i)
      if (std::abs(scale[i] - std::round(scale[i])) < 1e-6 && scale[i] > 0.5)
        first[i] = std::floor(first[i] + 0.5);
  view.origin = -first / scale;
  return view;
}

}  // namespace simreel::sim
