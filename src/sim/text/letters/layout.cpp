#include "sim/text/letters/layout.hpp"

#include "base/error.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace simreel::sim {

namespace {

/// Returns the lines as code points. Skips invalid UTF-8, which checkWritable() rejects.
std::vector<std::u32string> linesOf(std::string_view text) {
  std::vector<std::u32string> lines(1);
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = codePointLength(text, i);
    if (length == 0) {
      ++i;
      continue;
    }
    const char32_t code = codePoint(text.substr(i, length));
    if (code == U'\n')
      lines.emplace_back();
    else
      lines.back() += code;
    i += length;
  }
  return lines;
}

/// Adds a line of text that starts at (0, y). Returns its length.
double putLine(Font& font, const std::u32string& line, double y, TextOutlines& into) {
  double x = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (i > 0) x += font.kerning(line[i - 1], line[i]);
    const Font::Glyph& glyph = font.glyph(line[i]);
    for (auto polygon : glyph.outlines) {
      for (glm::dvec2& point : polygon) point += glm::dvec2(x, y);
      into.push_back(std::move(polygon));
    }
    x += glyph.advance;
  }
  return x;
}

double shareOf(TextAnchor::Across across) {
  return across == TextAnchor::Across::left ? 0 : across == TextAnchor::Across::center ? 0.5 : 1;
}

}  // namespace

TextOutlines written(Font& font, std::string_view text, const TextAnchor& anchor, double spacing) {
  const auto lines = linesOf(text);
  const double lineDistance = spacing * font.lineHeight();
  const double depth = lineDistance * static_cast<double>(lines.size() - 1);
  // Height of the baseline of the first line.
  double y = 0;
  if (anchor.down == TextAnchor::Down::top) y = -1;
  if (anchor.down == TextAnchor::Down::middle) y = 0.5 * (depth - 1);
  if (anchor.down == TextAnchor::Down::bottom) y = depth;
  TextOutlines all;
  for (const std::u32string& line : lines) {
    TextOutlines one;
    const double shift = -shareOf(anchor.across) * putLine(font, line, y, one);
    for (auto& polygon : one) {
      for (glm::dvec2& point : polygon) point.x += shift;
      all.push_back(std::move(polygon));
    }
    y -= lineDistance;
  }
  return all;
}

void checkWritable(const Font& font, std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = codePointLength(text, i);
    if (length == 0) fail(ExitCode::usage, "the text is not UTF-8");
    const char32_t code = codePoint(text.substr(i, length));
    if (code != U'\n' && !font.has(code))
      fail(ExitCode::usage, "the font has no \"{}\" (U+{:04X}); use other characters or another font",
           text.substr(i, length), static_cast<unsigned>(code));
    i += length;
  }
}

}  // namespace simreel::sim
