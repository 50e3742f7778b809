#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace simreel {

/// Whether the character is one of 0 to 9, whatever the locale.
[[nodiscard]] constexpr bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

/// Takes a whole number that an int holds, which may be negative, off the front.
[[nodiscard]] std::optional<int> takeInteger(std::string_view& text);
/// Two of them with a separator between, as in "1280x720", and nothing else.
[[nodiscard]] std::optional<std::pair<int, int>> integerPair(std::string_view text, char separator);

/// Bytes of the UTF-8 code point at `at`, 1 to 4; 0 when the bytes there are not valid UTF-8.
[[nodiscard]] std::size_t codePointLength(std::string_view text, std::size_t at);

/// The code point of one valid character.
[[nodiscard]] char32_t codePoint(std::string_view character);

/// Whether all of `text` is valid UTF-8.
[[nodiscard]] bool isUtf8(std::string_view text);

/// Whether one character of valid UTF-8 could steer a terminal or change the order in which text reads:
/// controls (U+0000 to U+001F, U+007F to U+009F), separators of lines, marks of writing direction.
[[nodiscard]] bool steersTerminal(std::string_view character);

/// The text with those and bytes that are no UTF-8 spelt out, \n, \x1b, \u202e, \xff: it prints as one
/// line, whatever file, name or argument it came from.
[[nodiscard]] std::string oneLine(std::string_view text);

/// The same for text of several lines, whose newlines and tabs stay.
[[nodiscard]] std::string severalLines(std::string_view text);

/// Lines that a service such as GitHub Actions would read as commands ("::" first, or "##[" anywhere) made
/// plain text.
[[nodiscard]] std::string withoutCommands(std::string_view text);

}  // namespace simreel
