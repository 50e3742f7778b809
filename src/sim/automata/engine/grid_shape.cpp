#include "sim/automata/engine/grid_shape.hpp"

#include <fmt/format.h>

namespace simreel::sim {

std::string GridShape::suffix(glm::ivec2 size) const {
  const auto shifted = [&](int along) { return along == 0 ? std::string() : fmt::format("{:+}", along); };
  const std::string x = shifted(shift.x), y = shifted(shift.y);
  switch (border) {
    case GridBorder::torus:
      return fmt::format(":T{}{},{}{}", size.x, x, size.y, y);
    case GridBorder::dead:
      return fmt::format(":P{},{}", size.x, size.y);
    case GridBorder::klein:
      return fmt::format(":K{}*{},{}", size.x, x, size.y);
    case GridBorder::kleinSideways:
      return fmt::format(":K{},{}*{}", size.x, size.y, y);
    case GridBorder::crossSurface:
      return fmt::format(":C{},{}", size.x, size.y);
    case GridBorder::sphere:
      return fmt::format(":S{}", size.x);
    case GridBorder::cylinder:
      break;
  }
  return {};
}

std::string GridShape::problem(glm::ivec2 size) const {
  if (border == GridBorder::sphere && size.x != size.y)
    return fmt::format("a sphere needs a square grid, not {} x {} cells", size.x, size.y);
  if (shift == glm::ivec2(0)) return {};
  if (shift.x != 0 && shift.y != 0)
    return "edges can be shifted in one direction only: one of the two numbers must be 0";
  const bool klein = border == GridBorder::klein || border == GridBorder::kleinSideways;
  if (border != GridBorder::torus && !klein)
    return "only a torus and a Klein bottle can have shifted edges";
  if ((border == GridBorder::klein && shift.y != 0) ||
      (border == GridBorder::kleinSideways && shift.x != 0))
    return "only the reversed edges of a Klein bottle can be shifted";
  if (klein && shift.x + shift.y != 1)
    return "the shift of a Klein bottle must be 0 or 1; all other shifts are equivalent to these";
  if (klein && (shift.x != 0 ? size.x : size.y) % 2 != 0)
    return "the shifted edges of a Klein bottle must have an even number of cells";
  return {};
}

shader::GridJoin GridShape::join(glm::ivec2 size) const {
  shader::GridJoin join;
  join.width = size.x;
  join.height = size.y;
  // In Golly's sign convention, an edge that is reversed is shifted in the opposite direction.
  join.shiftX = border == GridBorder::klein ? -shift.x : shift.x;
  join.shiftY = border == GridBorder::kleinSideways ? -shift.y : shift.y;
  const bool x = border != GridBorder::dead;
  join.across = !x ? 0 : border == GridBorder::kleinSideways || border == GridBorder::crossSurface ? 2 : 1;
  join.down = !x || border == GridBorder::cylinder                                ? 0
              : border == GridBorder::klein || border == GridBorder::crossSurface ? 2
                                                                                  : 1;
  if (border == GridBorder::sphere) join.across = join.down = 3;
  return join;
}

}  // namespace simreel::sim
