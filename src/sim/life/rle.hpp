#pragma once
#include "sim/life/cell_pattern.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Bits of a grid: rows of whole blocks of 128 cells, lowest bit of a word first, bits beyond a row's end
/// zero.
struct CellRows {
  glm::ivec2 size{0, 0};
  std::span<const std::uint32_t> words;
  [[nodiscard]] static int rowWords(int width) { return (width + 127) / 128 * 4; }
  [[nodiscard]] bool alive(int x, int y) const {
    const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(rowWords(size.x));
    return (words[row + static_cast<std::size_t>(x) / 32] >> (x % 32) & 1U) != 0;
  }
};

/// Reads RLE: comments (#), a header "x = 3, y = 3, rule = B3/S23" (all of it or the rule may be missing),
/// runs of b or . (dead), o or A (alive) and $ (end of row) over any number of lines, and the final !,
/// after which anything may follow; where a file with a header lacks it, a warning says so. `name` is what
/// messages call it. Throws UserError with file:line:column for a file of more than two states, a malformed
/// one, one cut off within a run, cells outside the header's size, or sides above maxLifeSide.
[[nodiscard]] CellPattern parseRle(std::string_view text, const std::string& name);

/// A grid as RLE of its whole size, lines of at most 70 characters. `border`: as CellPattern::border; a
/// comment may hold several lines.
[[nodiscard]] std::string writeRle(const CellRows& cells, const LifeRule& rule, char border,
                                   std::string_view comment);

}  // namespace simreel::sim
