#pragma once
#include <optional>
#include <string>

#include <glm/vec2.hpp>

namespace simreel::shader {
#define FUNCTION inline
#include "glsl/automata/shape.glsl"
#undef FUNCTION
}  // namespace simreel::shader

namespace simreel::sim {

/// Connection of a grid's edges, following Golly's bounded grids. dead: edges are not connected. torus:
/// each edge continues at the opposite edge. cylinder: only left and right are connected. klein: like
/// torus, with top and bottom reversed. kleinSideways: like torus, with left and right reversed.
/// crossSurface: both reversed. sphere: top is connected to left and right to bottom, for square grids
/// only.
enum class GridBorder { torus, dead, cylinder, klein, kleinSideways, crossSurface, sphere };

struct GridShape {
  GridBorder border = GridBorder::torus;
  /// Shift in cells along the lower edge (x) or the right edge (y) with which the grid continues there, for
  /// a torus or a Klein bottle. At most one component is nonzero; for a Klein bottle it is 0 or 1.
  glm::ivec2 shift{0, 0};
  bool operator==(const GridShape&) const = default;
  /// Returns the rule suffix for a grid of this size in Golly's notation, such as ":T30+5,20"; empty if
  /// Golly does not support the grid.
  [[nodiscard]] std::string suffix(glm::ivec2 size) const;
  /// Returns the reason why a grid of this size cannot have this border; empty if it can.
  [[nodiscard]] std::string problem(glm::ivec2 size) const;
  /// Returns the border as kernel parameters.
  [[nodiscard]] shader::GridJoin join(glm::ivec2 size) const;
};

}  // namespace simreel::sim
