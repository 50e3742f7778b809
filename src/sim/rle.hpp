#pragma once
#include "sim/life_rule.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

/// A pattern of living and dead cells, as the community's RLE files hold them.
struct RlePattern {
  /// Living cells side by side.
  struct Run {
    int x, y, length;
  };
  glm::ivec2 size{0, 0};         ///< of the header
  std::vector<Run> runs;         ///< by rows, from the left
  std::optional<LifeRule> rule;  ///< of the header
  /// Bounded grid of the rule's suffix, as in "B3/S23:T257,130": 'T' torus, 'P' dead border, 0: none.
  char border = 0;
  glm::ivec2 grid{0, 0};
};

/// Sides of patterns and grids, cells.
inline constexpr int mostLifeSide = 1 << 20;

/// Reads an RLE file: comments (#), a header "x = 3, y = 3, rule = B3/S23" (the rule may be missing), runs
/// of b (dead), o (alive) and $ (end of row) over any number of lines, and the final !, after which
/// anything may follow. Throws UserError with file:line:column for a file of more than two states, a
/// malformed or cut-off one, cells outside the header's size, or sides above mostLifeSide.
[[nodiscard]] RlePattern readRle(const std::filesystem::path& file);
/// The same from text; `name` is what messages call it.
[[nodiscard]] RlePattern parseRle(std::string_view text, const std::string& name);

/// A grid as RLE of its whole size, lines of at most 70 characters. `border`: as RlePattern::border; a
/// comment may hold several lines.
[[nodiscard]] std::string writeRle(const CellRows& cells, const LifeRule& rule, char border,
                                   std::string_view comment);

}  // namespace simreel::sim
