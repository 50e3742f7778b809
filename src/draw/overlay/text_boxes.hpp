#pragma once
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

/// Texture unit at which shaders of boxes (charts, scales) read them.

/// Letters as rectangles of pixels (left, top, right, bottom): stb_easy_font at a whole magnification, so
/// they are sharp. What is not ASCII becomes a question mark.
[[nodiscard]] std::vector<glm::vec4> textBoxes(const std::string& text, glm::ivec2 topLeft, int scale);
/// Magnification of letters, thickness of thin lines: pixels.
[[nodiscard]] int letterUnit(glm::ivec2 picture);
/// Width and height of the capitals, pixels.
[[nodiscard]] glm::ivec2 textSize(const std::string& text, int scale);

}  // namespace simreel::draw
