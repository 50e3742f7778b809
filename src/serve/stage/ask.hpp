#pragma once
#include "serve/script/script.hpp"
#include "sim/world/world.hpp"

#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::serve {

/// What is known of a pixel.
struct PixelAnswer {
  struct Row {
    std::string name;
    std::optional<double> value;
    std::string text;  ///< instead of a value; or the bits of one, as hexadecimal digits
  };
  std::string title;  ///< "triangle 12 of flag", "cell (3, 4) of dish", "the sky"
  std::vector<Row> rows;
};

/// A field that is laid over the picture, and where in it a place of the picture is (cells).
struct FieldPoint {
  std::string object;
  glm::dvec2 cell{0};
};
/// Of the uppermost one there, at a place as fractions of the picture.
[[nodiscard]] std::optional<FieldPoint> fieldAt(const scene::Scene& scene, const sim::World& world,
                                                glm::dvec2 place);

/// Of the pixel that a place is in, as fractions of the picture from its top left: which object, which of
/// its primitives, where that is, and what state the element has that lies next to it. Draws the picture
/// once more, with the exact rasterizer. Throws UserError as Renderer does.
[[nodiscard]] PixelAnswer askPixel(const scene::Scene& scene, sim::World& world, glm::dvec2 place);

}  // namespace simreel::serve
