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

/// How the edges of a grid are joined, after Golly's bounded grids.
/// dead: to nothing. torus: each to the opposite one. cylinder: left to right. klein: as a torus, top to
/// bottom reversed. kleinSideways: left to right reversed. crossSurface: both reversed. sphere: top to
/// left, right to bottom; square grids only.
enum class GridBorder { torus, dead, cylinder, klein, kleinSideways, crossSurface, sphere };

struct GridShape {
  GridBorder border = GridBorder::torus;
  /// Of a torus and a Klein bottle: cells by which what is met beyond the lower (x) or the right (y) edge
  /// lies further along it; one of the two at most, of a Klein bottle 0 or 1.
  glm::ivec2 shift{0, 0};
  bool operator==(const GridShape&) const = default;
  /// As a rule's suffix says it, for a grid of this size: ":T30+5,20"; empty where Golly has no such grid.
  [[nodiscard]] std::string suffix(glm::ivec2 size) const;
  /// Why a grid of this size cannot have this border; empty: it can.
  [[nodiscard]] std::string problem(glm::ivec2 size) const;
  /// As kernels take it.
  [[nodiscard]] shader::GridJoin join(glm::ivec2 size) const;
};

}  // namespace simreel::sim
