#pragma once
#include "sim/life/rule.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Sides of patterns and grids, cells.
inline constexpr int maxLifeSide = 1 << 20;

/// A pattern of living and dead cells, as the community's files hold them.
struct CellPattern {
  /// Living cells side by side.
  struct Run {
    int x, y, length;
  };
  glm::ivec2 size{0, 0};         ///< that the file says, else just around the living cells
  std::vector<Run> runs;         ///< of RLE and plaintext by rows, from the left
  std::optional<LifeRule> rule;  ///< where the file names one
  /// Bounded grid of an RLE rule's suffix, as in "B3/S23:T257,130": 'T' torus, 'P' dead border, 0: none.
  char border = 0;
  glm::ivec2 grid{0, 0};
};

/// File names that hold patterns, lower case: ".rle", ".cells", ".life", ".lif".
[[nodiscard]] bool isPatternName(const std::filesystem::path& file);

/// Reads a pattern in whichever format it is: Life 1.05 and 1.06 by their first line, plaintext (rows of
/// '.' and 'O', comments after '!') where nothing but such rows is there, else RLE. Throws UserError with
/// file:line:column for one that cannot be read, has more than two states, or has sides above maxLifeSide.
[[nodiscard]] CellPattern readPattern(const std::filesystem::path& file);
/// The same from text; `name` is what messages call it.
[[nodiscard]] CellPattern parsePattern(std::string_view text, const std::string& name);

/// A reader's place in the text of a pattern.
class PatternText {
 public:
  PatternText(std::string_view text, const std::string& name) : text_(text), name_(name) {}
  /// Throws UserError(usage): file:line:column of the character `at`, and the message.
  [[noreturn]] void wrong(std::size_t at, const std::string& message) const;
  /// A character as messages show it.
  [[nodiscard]] static std::string shown(char c);

 protected:
  /// Adds living cells; joins them to the run before where they follow it.
  void add(int x, int y, int length);

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  CellPattern pattern_;
};

}  // namespace simreel::sim
