#pragma once
#include "scene/scene.hpp"

#include <string>

#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>

namespace simreel::serve {

/// A piece of the brush's way over a field.
struct BrushPiece {
  double time = 0;            ///< s of the frame that is painted
  glm::dvec2 from{0}, to{0};  ///< cells
  double radius = 1;          ///< cells
  double value = 1;           ///< as the strokes of the kind have it
};

/// The strokes of an object, from its scene's text (the object of its kind): what the scene gives, or the
/// jets of a fluid that is given none.
[[nodiscard]] nlohmann::json strokesOf(const scene::Object& object, const nlohmann::json& given);

/// The entry of "strokes" that paints so. It begins at the step that the frame shows, which may be before
/// the frame. In a fluid it sets dye, or what the fluid has of heat, and pushes as fast as the mouse goes.
[[nodiscard]] nlohmann::json strokeOf(const scene::Object& object, const nlohmann::json& given,
                                      const BrushPiece& piece);

}  // namespace simreel::serve
