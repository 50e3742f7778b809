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

/// Sides of patterns and grids, cells.
inline constexpr int maxLifeSide = 1 << 20;

/// A pattern of cells, as the community's files hold them.
struct CellPattern {
  /// Cells of one state, not 0, side by side.
  struct Run {
    int x, y, length;
    int state = 1;
  };
  glm::ivec2 size{0, 0};         ///< that the file says, else just around the living cells
  std::vector<Run> runs;         ///< of RLE and plaintext by rows, from the left
  std::optional<CellRule> rule;  ///< where the file names one
  /// A name that is no notation, which a file NAME.rule beside the pattern explains; and where it stands.
  std::string ruleName, rulePlace;
  int highest = 1;           ///< state
  std::string highestPlace;  ///< of the first cell that has it, "file:line:column"
  /// Bounded grid of an RLE rule's suffix, as in "B3/S23:T257,130".
  std::optional<GridShape> shape;
  glm::ivec2 grid{0, 0};
  /// Its top left corner in that grid, where the file says it.
  std::optional<glm::ivec2> corner;
  std::string remark;  ///< one line for a user, of a file that can be read but may be damaged; else empty
};

/// Whether a file's name ends as those of patterns do: ".rle", ".cells", ".life", ".lif", ".mc", and each
/// with
/// ".gz" behind it.
[[nodiscard]] bool isPatternName(const std::filesystem::path& file);

/// Reads a pattern in whichever format it is: Life 1.05 and 1.06 and macrocell by their first line,
/// plaintext (rows of
/// '.' and 'O', comments after '!') where nothing but such rows is there, else RLE; each also packed by
/// gzip, of up to 64 MiB. Throws UserError with file:line:column for one that cannot be read or has sides
/// above maxLifeSide.
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
  /// Adds cells of a state, which the character `from` begins; joins them to the run before where they
  /// follow it.
  void add(int x, int y, int length, int state = 1, std::size_t from = 0);
  /// "file:line:column" of a character.
  [[nodiscard]] std::string place(std::size_t at) const;
  /// Takes a rule: a notation, or a name that a .rule file is to explain. In files "B234" is a rule: of
  /// cells that never survive.
  void takeRuleText(std::size_t at, std::string_view text);
  /// Takes the suffix of a bounded grid from the character `start` of the text on, such as "T30+5,20",
  /// "P30,20", "K30*,20", "C30,20" or "S30". Returns where it ends.
  std::size_t takeGrid(std::size_t start);

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  CellPattern pattern_;
};

}  // namespace simreel::sim
