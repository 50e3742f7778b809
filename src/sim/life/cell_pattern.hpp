#pragma once
#include "sim/automata/engine/grid_shape.hpp"
#include "sim/automata/rule/cell_rule.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

namespace simreel::sim {

/// Maximum width and height of patterns and grids, in cells.
inline constexpr int maxLifeSide = 1 << 20;

/// Pattern of cells as read from a pattern file.
struct CellPattern {
  /// Horizontal run of cells of one state other than 0.
  struct Run {
    int x, y, length;
    int state = 1;
  };
  glm::ivec2 size{0, 0};         ///< size given by the file, otherwise the size of the bounding box of the
                                 ///< live cells
  std::vector<Run> runs;         ///< runs; for RLE and plaintext sorted by row, then by column
  std::optional<CellRule> rule;  ///< rule named by the file, if any
  /// Name of a rule, if it is not a rule notation, and the position of the name in the file. A file
  /// NAME.rule in the pattern's folder must define the rule.
  std::string ruleName, rulePlace;
  int highest = 1;           ///< maximum state in the pattern
  std::string highestPlace;  ///< "file:line:column" of the first cell in the maximum state
  /// Bounded grid given by the suffix of an RLE rule, for example "B3/S23:T257,130".
  std::optional<GridShape> shape;
  glm::ivec2 grid{0, 0};
  /// Top left corner of the pattern in that grid, if the file gives it.
  std::optional<glm::ivec2> corner;
  std::string remark;  ///< one-line warning about a readable file that may be damaged; otherwise empty
};

/// Returns true if a file name ends in ".rle", ".cells", ".life", ".lif" or ".mc", optionally followed by
/// ".gz".
[[nodiscard]] bool isPatternName(const std::filesystem::path& file);

/// Reads a pattern and detects its format. Life 1.05, Life 1.06 and macrocell are detected by the first
/// line. A file with only rows of '.' and 'O' and comments after '!' is plaintext; any other file is RLE. A
/// file may be compressed by gzip, up to 64 MiB uncompressed. Throws UserError with file:line:column for an
/// unreadable pattern or one with a side above maxLifeSide.
[[nodiscard]] CellPattern readPattern(const std::filesystem::path& file);
/// Parses a pattern from text like readPattern(). `name` is the file's name in messages.
[[nodiscard]] CellPattern parsePattern(std::string_view text, const std::string& name);

/// Base class of pattern parsers. It holds the current position in the text and the pattern that has been
/// read so far.
class PatternText {
 public:
  PatternText(std::string_view text, const std::string& name) : text_(text), name_(name) {}
  /// Throws UserError(usage) with the file:line:column of the character `at` and the message.
  [[noreturn]] void wrong(std::size_t at, const std::string& message) const;
  /// Returns a character as it is shown in messages.
  [[nodiscard]] static std::string shown(char c);

 protected:
  /// Adds a run of cells with the given state. `from` is the offset of the text that describes them. If the
  /// cells continue the previous run, extends that run.
  void add(int x, int y, int length, int state = 1, std::size_t from = 0);
  /// Returns "file:line:column" of a character offset.
  [[nodiscard]] std::string place(std::size_t at) const;
  /// Stores a rule, given as a notation or as a name that a .rule file must define. In files, "B234"
  /// without "/S" is also a valid rule; its cells never survive.
  void takeRuleText(std::size_t at, std::string_view text);
  /// Parses the suffix of a bounded grid at the offset `start`, such as "T30+5,20", "P30,20", "K30*,20",
  /// "C30,20" or "S30". Returns the offset of its end.
  std::size_t takeGrid(std::size_t start);

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  CellPattern pattern_;
};

}  // namespace simreel::sim
