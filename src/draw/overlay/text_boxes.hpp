#pragma once
#include "sim/grid/field_view.hpp"

#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace simreel::draw {

using sim::letterUnit;

/// Returns text as rectangles (left, top, right, bottom; pixels), in stb_easy_font at an integer
/// magnification, so that letters are sharp. Question marks replace non-ASCII characters.
[[nodiscard]] std::vector<glm::vec4> textBoxes(const std::string& text, glm::ivec2 topLeft, int scale);
/// Returns the width of the text and the height of its capitals (pixels).
[[nodiscard]] glm::ivec2 textSize(const std::string& text, int scale);

}  // namespace simreel::draw
