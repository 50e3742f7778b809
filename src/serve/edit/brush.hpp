#pragma once
#include "scene/scene.hpp"

#include <string>

#include <glm/vec2.hpp>
#include <nlohmann/json.hpp>

namespace simreel::serve {

/// Segment of a brush stroke over a field.
struct BrushPiece {
  double time = 0;            ///< time of the painted frame in seconds
  glm::dvec2 from{0}, to{0};  ///< end points of the segment in cells
  double radius = 1;          ///< radius of the brush in cells
  double value = 1;           ///< painted value in the units of the object's "strokes"
};

/// Returns the "strokes" of an object. `given`: the object's parameters in the scene. If the scene gives no
/// "strokes", returns the default strokes, such as the jets of a fluid.
[[nodiscard]] nlohmann::json strokesOf(const scene::Object& object, const nlohmann::json& given);

/// Returns the entry of "strokes" that paints the segment. The stroke begins at the simulation step that
/// the frame shows, which may be earlier than the frame's time. In a fluid the stroke sets the velocity of
/// the mouse, and dye, or temperature if the fluid has heat.
[[nodiscard]] nlohmann::json strokeOf(const scene::Object& object, const nlohmann::json& given,
                                      const BrushPiece& piece);

}  // namespace simreel::serve
