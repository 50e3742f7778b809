#pragma once
#include "sim/text/letters/font.hpp"

#include <string_view>

namespace simreel::sim {

/// Point of the text that is placed at (0, 0).
struct TextAnchor {
  enum class Across { left, center, right };
  enum class Down { baseline, top, middle, bottom };  ///< baseline: of the first line; top: of its capitals
  Across across = Across::center;
  Down down = Down::baseline;
};

/// Returns the outlines of UTF-8 text in units of a capital's height, y up. "\n" separates lines; their
/// distance is `spacing` times the font's own.
[[nodiscard]] TextOutlines written(Font& font, std::string_view text, const TextAnchor& anchor,
                                   double spacing);

/// Throws UserError(usage) if the text is not UTF-8 or contains a character that the font does not have;
/// the message names it.
void checkWritable(const Font& font, std::string_view text);

}  // namespace simreel::sim
