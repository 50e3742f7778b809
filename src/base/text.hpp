#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace simreel {

/// True if the character is 0 to 9, independent of the locale.
[[nodiscard]] constexpr bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Removes a whole number, possibly negative, from the beginning of the text and returns it. Returns
/// nullopt if the text does not begin with a number that fits into an int.
[[nodiscard]] std::optional<int> takeInteger(std::string_view& text);
/// Parses two whole numbers with a separator between them, such as "1280x720". Returns nullopt for any
/// other text.
[[nodiscard]] std::optional<std::pair<int, int>> integerPair(std::string_view text, char separator);

/// Returns the length in bytes of the UTF-8 code point at index `at`, 1 to 4, or 0 if the bytes are not
/// valid UTF-8.
[[nodiscard]] std::size_t codePointLength(std::string_view text, std::size_t at);

/// Returns the code point of one valid UTF-8 character.
[[nodiscard]] char32_t codePoint(std::string_view character);

/// True if all of `text` is valid UTF-8.
[[nodiscard]] bool isUtf8(std::string_view text);

/// True if a valid UTF-8 character can control a terminal or change the reading order of text. These are
/// control characters (U+0000 to U+001F, U+007F to U+009F), line separators, and marks of writing
/// direction.
[[nodiscard]] bool isTerminalControl(std::string_view character);

/// Returns the text as one line. Newlines, other control characters and invalid UTF-8 are escaped (\x1b,
/// \u202e, \xff), so that text from any file, name or argument can be printed safely.
[[nodiscard]] std::string oneLine(std::string_view text);

/// Does the same as oneLine(), but keeps newlines and tabs.
[[nodiscard]] std::string severalLines(std::string_view text);

/// Changes lines that a service such as GitHub Actions would interpret as commands ("::" at the start,
/// "##[" anywhere) to plain text.
[[nodiscard]] std::string withoutCommands(std::string_view text);

}  // namespace simreel
