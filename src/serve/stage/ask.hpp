#pragma once
#include "serve/script/script.hpp"
#include "sim/world/world.hpp"

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::serve {

/// Information about one pixel.
struct PixelInfo {
  struct Row {
    std::string name;
    std::optional<double> value;
    std::string text;  ///< text of the row; if the row has a value, this is the value's bits as hexadecimal
                       ///< digits
  };
  std::string title;  ///< title of the answer, such as "triangle 12 of flag", "cell (3, 4) of dish" or "the
                      ///< sky"
  std::vector<Row> rows;
};

/// Field that is drawn over the picture, and a position in the field in cells.
struct FieldPoint {
  std::string object;
  glm::dvec2 cell{0};
};
/// Returns the topmost field at a position in the picture, given as fractions of the picture's size.
[[nodiscard]] std::optional<FieldPoint> fieldAt(const scene::Scene& scene, const sim::World& world,
                                                glm::dvec2 place);

/// Returns information about the pixel at `place` (fractions of the picture's size, from its top left). The
/// information consists of the object, its primitive, the position, and the state of the nearest element.
/// Draws the picture again with the exact rasterizer. Throws the errors of Renderer.
[[nodiscard]] PixelInfo pixelInfo(const scene::Scene& scene, sim::World& world, glm::dvec2 place);

}  // namespace simreel::serve
