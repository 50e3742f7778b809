#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::sim {

/// Lines of a rule file's sections, with their positions in the file.
class RuleFileText {
 public:
  struct Line {
    int number;             ///< line number, counted from 1
    std::size_t column;     ///< zero-based column of the text's first character
    std::string_view text;  ///< text without comment, surrounding blanks and line end
  };
  /// `name` is the file's name in messages.
  RuleFileText(std::string_view text, std::string name);

  /// Returns the lines of the section "@NAME". Text after the name in the same line counts as the first
  /// line.
  [[nodiscard]] std::vector<Line> section(std::string_view name) const;
  [[nodiscard]] bool has(std::string_view name) const { return find(name) >= 0; }
  /// Returns the zero-based index of the line that starts the section; negative if none exists.
  [[nodiscard]] int find(std::string_view name) const;

  /// Throws UserError(usage) with file:line:column and the message. `at` is an offset in the line's text.
  [[noreturn]] void wrong(const Line& line, std::size_t at, const std::string& message) const;
  [[noreturn]] void wrong(const std::string& message) const;  ///< Throws UserError(usage) with the file's
                                                              ///< name.
  /// Returns the number in `word`, which may be at most `max`. `at` is the offset of `word` in the line,
  /// for messages.
  [[nodiscard]] int number(const Line& line, std::size_t at, std::string_view word, int max,
                           const char* what) const;

 private:
  std::string name_;
  std::vector<std::string_view> lines_;
};

/// Word of a line, with its offset in the line.
struct RuleWord {
  std::size_t at;
  std::string_view text;
};
/// Splits a text at blanks, or at commas without the blanks around them.
[[nodiscard]] std::vector<RuleWord> wordsOf(std::string_view text, bool commas);

}  // namespace simreel::sim
