#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace simreel::sim {

/// The lines of a rule file's section, with their places in the file.
class RuleFileText {
 public:
  struct Line {
    int number;             ///< from 1
    std::size_t column;     ///< of its first character that is left, from 0
    std::string_view text;  ///< without comment, blanks around it and line end
  };
  /// `name` is what messages call the file.
  RuleFileText(std::string_view text, std::string name);

  /// Lines of the section "@NAME"; what follows the name on its own line is its first line.
  [[nodiscard]] std::vector<Line> section(std::string_view name) const;
  [[nodiscard]] bool has(std::string_view name) const { return find(name) >= 0; }
  /// The number of the line that begins the section, from 0; below 0: there is none.
  [[nodiscard]] int find(std::string_view name) const;

  /// Throws UserError(usage): file:line:column and the message; `at` counts from the line's text.
  [[noreturn]] void wrong(const Line& line, std::size_t at, const std::string& message) const;
  [[noreturn]] void wrong(const std::string& message) const;  ///< of the whole file
  /// The number that is all of `word`, which begins at `at` of the line; up to `max`.
  [[nodiscard]] int number(const Line& line, std::size_t at, std::string_view word, int max,
                           const char* what) const;

 private:
  std::string name_;
  std::vector<std::string_view> lines_;
};

/// Words of a line between blanks, each with where it begins.
struct RuleWord {
  std::size_t at;
  std::string_view text;
};
/// Words between blanks, or between commas (blanks around them left out).
[[nodiscard]] std::vector<RuleWord> wordsOf(std::string_view text, bool commas);

}  // namespace simreel::sim
