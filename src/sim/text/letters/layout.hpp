#pragma once
#include "sim/text/letters/font.hpp"

#include <string_view>

namespace simreel::sim {

/// Point of the text that is placed at (0, 0).
struct TextAnchor {
  enum class Across { left, center, right };
  enum class Down {
    baseline,
    top,
    middle,
    bottom
  };  ///< baseline: baseline of the first line; top: top of
      ///< the capitals in the first line
  Across across = Across::center;
  Down down = Down::baseline;
};

/// Returns the outlines of UTF-8 text in units of the cap height, with y up. A line feed separates lines.
/// The line distance is `spacing` times the line height of the font.
[[nodiscard]] TextOutlines written(Font& font, std::string_view text, const TextAnchor& anchor,
                                   double spacing);

/// Throws UserError(usage) if the text is not UTF-8 or contains a character that the font does not have.
/// The message names the character.
void checkWritable(const Font& font, std::string_view text);

}  // namespace simreel::sim
