#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace simreel::sim {

/// Removes the next word from a line and returns it; empty if none is left.
[[nodiscard]] std::string_view takeWord(std::string_view& line);
/// Returns the text without blanks at both ends.
[[nodiscard]] std::string_view withoutBlanks(std::string_view text);

/// Returns a line of OBJ or MTL without its comment, which begins with '#'. If `ofNames` is true, only a
/// '#' at the start of a word begins a comment.
[[nodiscard]] std::string_view withoutComment(std::string_view line, bool ofNames);

/// Parse a whole word as a decimal number in any notation (".5", "+1", "5.", "1e-3", "nan") with correct
/// rounding. Values that are too large for the type give infinity.
[[nodiscard]] std::optional<float> floatIn(std::string_view word);
[[nodiscard]] std::optional<double> doubleIn(std::string_view word);

/// Iterates over the lines of a text, which end with "\n", "\r\n" or "\r".
class TextLines {
 public:
  explicit TextLines(std::string_view text) : rest_(text) {}
  /// Reads the next line without its end. Returns false at the end of the text.
  bool next(std::string_view& line);
  /// Returns the number of the line that was read last, counted from 1.
  [[nodiscard]] std::size_t number() const { return number_; }
  /// Returns the text after the line that was read last.
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

/// Returns a line for messages, shortened and in quotes.
[[nodiscard]] std::string inQuotes(std::string_view line);

}  // namespace simreel::sim
