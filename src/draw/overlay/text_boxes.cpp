#include "draw/overlay/text_boxes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb/stb_easy_font.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace simreel::draw {

namespace {

constexpr int capitals = 9;  // number of rows from the top of a line to the baseline

std::string printable(const std::string& text) {
  std::string result = text.substr(0, 64);
  std::replace_if(
      result.begin(), result.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return result;
}

}  // namespace

std::vector<glm::vec4> textBoxes(const std::string& text, glm::ivec2 topLeft, int scale) {
  struct Corner {
    float x, y, z;
    unsigned color;
  };
  std::string letters = printable(text);
  std::vector<Corner> corners(letters.size() * 20 * 4 + 4);
  const int boxes = stb_easy_font_print(0, 0, letters.data(), nullptr, corners.data(),
                                        static_cast<int>(corners.size() * sizeof(Corner)));
  std::vector<glm::vec4> result;
  const glm::vec2 from(topLeft);
  const auto times = static_cast<float>(scale);
  for (int i = 0; i < boxes; ++i) {
    const Corner& a = corners[4 * static_cast<std::size_t>(i)];
    const Corner& c = corners[4 * static_cast<std::size_t>(i) + 2];
    result.emplace_back(from + times * glm::vec2(a.x, a.y), from + times * glm::vec2(c.x, c.y));
  }
  return result;
}

glm::ivec2 textSize(const std::string& text, int scale) {
  std::string letters = printable(text);
  return scale * glm::ivec2(stb_easy_font_width(letters.data()), capitals);
}

}  // namespace simreel::draw
