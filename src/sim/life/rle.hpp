#pragma once
#include "sim/life/cell_pattern.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Cells of a grid as bits. Rows consist of whole blocks of 128 cells, with the lowest bit of a word first;
/// bits beyond the end of a row are zero.
struct CellRows {
  glm::ivec2 size{0, 0};
  std::span<const std::uint32_t> words;
  [[nodiscard]] static int rowWords(int width) { return (width + 127) / 128 * 4; }
  [[nodiscard]] bool alive(int x, int y) const {
    const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(rowWords(size.x));
    return (words[row + static_cast<std::size_t>(x) / 32] >> (x % 32) & 1U) != 0;
  }
};

/// Parses RLE:
/// - comments (#)
/// - an optional header "x = 3, y = 3, rule = B3/S23", whose rule is optional, too
/// - runs of b or . (state 0), o (1), A to X (1 to 24), pA to yO (25 to 255) and $ (end of row) over any
///   number of lines
/// - the final !, after which anything may follow; `remark` reports if a file with a header lacks it
///
/// `name` is the file's name in messages. Throws UserError with file:line:column for malformed text, text
/// truncated within a run, cells outside the header's size, and sides above maxLifeSide.
[[nodiscard]] CellPattern parseRle(std::string_view text, const std::string& name);

/// Returns a whole grid as RLE in lines of at most 70 characters. `suffix` is the suffix of a bounded grid
/// (GridShape::suffix); `comment` may have several lines.
[[nodiscard]] std::string writeRle(const CellRows& cells, const CellRule& rule, std::string_view suffix,
                                   std::string_view comment);

/// States of a grid, one byte per cell. Rows consist of whole blocks of 16 cells.
struct StateRows {
  glm::ivec2 size{0, 0};
  std::span<const std::uint8_t> bytes;
  [[nodiscard]] static int rowBytes(int width) { return (width + 15) / 16 * 16; }
  [[nodiscard]] int state(int x, int y) const {
    const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(rowBytes(size.x));
    return bytes[row + static_cast<std::size_t>(x)];
  }
};

/// Returns a grid with more than two states as RLE. The states are written as ., A to X and pA to yO.
[[nodiscard]] std::string writeStatesRle(const StateRows& cells, const CellRule& rule,
                                         std::string_view suffix, std::string_view comment);

}  // namespace simreel::sim
