#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace simreel::scene {

/// A syntax error in our words; bytes [begin, end) of the text.
struct SyntaxError {
  std::size_t begin;
  std::size_t end;
  std::string message;
};

/// First byte of the string whose text, closing quote included or not, ends before byte `end`.
[[nodiscard]] std::size_t openingQuote(std::string_view text, std::size_t end);

/// Whether the character may stand in a number.
[[nodiscard]] bool isPartOfNumber(char c);

/// Turns what the JSON parser knows into a message for people. `consumed`: bytes it has read; `what`:
/// its own message; `openedAt`: byte of the innermost open bracket, or npos.
[[nodiscard]] SyntaxError explainSyntaxError(std::string_view text, std::size_t consumed,
                                             std::string_view what, std::size_t openedAt);

}  // namespace simreel::scene
