#pragma once
#include "sim/text/letters/font.hpp"

#include <string_view>

namespace simreel::sim {

/// Where (0, 0) lies of what is written.
struct TextAnchor {
  enum class Across { left, center, right };
  enum class Down { baseline, top, middle, bottom };  ///< baseline: of the first line; top: of its capitals
  Across across = Across::center;
  Down down = Down::baseline;
};

/// Outlines of UTF-8 text, in heights of a capital, y up. Lines end with "\n" and lie `spacing` times the
/// font's own distance apart.
[[nodiscard]] TextOutlines written(Font& font, std::string_view text, const TextAnchor& anchor,
                                   double spacing);

/// Throws UserError(usage) for text that is not UTF-8, or that has characters which the font has not, and
/// says which.
void checkWritable(const Font& font, std::string_view text);

}  // namespace simreel::sim
