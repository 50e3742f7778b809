#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace simreel::scene {

/// Syntax error with its message. The byte range in the text includes `begin` but not `end`.
struct SyntaxError {
  std::size_t begin;
  std::size_t end;
  std::string message;
};

/// Returns the index of the last unescaped quote before byte `end`. This is the opening quote of a string
/// that is closed at `end` or not at all.
[[nodiscard]] std::size_t openingQuote(std::string_view text, std::size_t end);

/// True if the character can be part of a number.
[[nodiscard]] bool isPartOfNumber(char c);

/// Converts an error of the JSON parser to a message for users. `consumed`: number of bytes that the parser
/// has read; `what`: the parser's message; `openedAt`: index of the innermost open bracket, or npos.
[[nodiscard]] SyntaxError explainSyntaxError(std::string_view text, std::size_t consumed,
                                             std::string_view what, std::size_t openedAt);

}  // namespace simreel::scene
