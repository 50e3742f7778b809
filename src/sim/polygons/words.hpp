#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace simreel::sim {

/// Takes the next word off a line; empty where none is left.
[[nodiscard]] std::string_view takeWord(std::string_view& line);
/// Without blanks at both ends.
[[nodiscard]] std::string_view withoutBlanks(std::string_view text);

/// A line of OBJ or MTL up to its comment, which begins with '#'; in a line of names at the start of a word
/// only.
[[nodiscard]] std::string_view withoutComment(std::string_view line, bool ofNames);

/// All of a word as a decimal number of any notation (".5", "+1", "5.", "1e-3", "nan"), rounded once; of
/// one too large for the type, infinity.
[[nodiscard]] std::optional<float> floatIn(std::string_view word);
[[nodiscard]] std::optional<double> doubleIn(std::string_view word);

/// The lines of a text. Each ends with "\n", "\r\n" or "\r".
class TextLines {
 public:
  explicit TextLines(std::string_view text) : rest_(text) {}
  /// The next line without its end. False where there is none.
  bool next(std::string_view& line);
  /// The number of that line, from 1 on.
  [[nodiscard]] std::size_t number() const { return number_; }
  /// What follows that line.
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

/// A line as a message quotes it.
[[nodiscard]] std::string inQuotes(std::string_view line);

}  // namespace simreel::sim
