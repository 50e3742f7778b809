#include "scene/json/json_error.hpp"

#include "scene/json/words.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

namespace simreel::scene {

namespace {

bool isWord(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '+' || c == '-';
}

std::string explainWord(std::string_view word) {
  std::string small(word);
  std::transform(small.begin(), small.end(), small.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  if (small.find("nan") != std::string::npos || small.find("inf") != std::string::npos)
    return fmt::format("{} is not a number in JSON; give a finite number", word);
  for (const char* known : {"true", "false", "null"})
    if (small == known) return fmt::format("unknown word {}; JSON writes {}", word, known);
  if (small == "none" || small == "undefined" || small == "nil")
    return fmt::format("unknown word {}", word);
  return fmt::format("unknown word {}; strings and keys need double quotes", inQuotes(word));
}

/// Explains a valid token at a position where JSON does not allow it.
std::string explainUnexpected(std::string_view what, std::string_view text, std::size_t begin) {
  const auto says = [&](std::string_view part) { return what.find(part) != std::string_view::npos; };
  const char found = text[begin];
  const std::size_t before = text.substr(0, begin).find_last_not_of(" \t\r\n");
  const bool afterComma = before != std::string_view::npos && text[before] == ',';
  if (says("expected end of input")) return "the scene ended before this; remove what follows";
  if (says("while parsing object key"))
    return found == '}' && afterComma ? "a comma stands before this '}'; remove it"
                                      : "expected a key in double quotes";
  if (says("while parsing object separator")) return "expected ':' between key and value";
  if (says("unexpected number literal") && found == '0') return "a number has no leading zero";
  if (says("while parsing object ")) return "expected ',' or '}'; is a comma missing?";
  if (says("while parsing array")) return "expected ',' or ']'; is a comma missing?";
  if (found == ']' && afterComma) return "a comma stands before this ']'; remove it";
  return "expected a value";
}

std::string explainString(std::string_view what, char last) {
  const auto says = [&](std::string_view part) { return what.find(part) != std::string_view::npos; };
  if (says("UTF-8")) return "not valid UTF-8; save the text as UTF-8";
  if (says("backslash"))
    return "unknown escape; JSON has \\\" \\\\ \\/ \\b \\f \\n \\r \\t and \\u with four digits";
  if (says("4 hex digits")) return "\\u needs four hexadecimal digits";
  if (says("surrogate")) return "half of a surrogate pair; a character beyond U+FFFF needs both halves";
  return fmt::format("control character U+{:04X} in a string; write it as an escape, for example \\t",
                     static_cast<unsigned char>(last));
}

/// Explains an unknown word, or a character that cannot start a token. The parser stops at the first wrong
/// character, so the word is searched for on both sides of this character.
SyntaxError explainLiteral(std::string_view text, std::size_t last) {
  std::size_t begin = last;
  if (isWord(text[last])) {
    while (begin > 0 && isWord(text[begin - 1])) --begin;
  } else {
    while (begin > 0 && std::isalpha(static_cast<unsigned char>(text[begin - 1])) != 0) --begin;
    // The error covers letters before the wrong character only if they begin true, false or null, as in
    // `tru}`.
    if (begin < last && std::string_view("tfn").find(text[begin]) == std::string_view::npos) begin = last;
  }
  std::size_t end = begin;
  while (end < text.size() && isWord(text[end])) ++end;
  if (text[begin] == '\'') return {begin, begin + 1, "strings and keys need double quotes"};
  if (begin == end) return {begin, begin + 1, "this character does not belong here"};
  const std::string_view word = text.substr(begin, end - begin);
  const bool letters = std::any_of(word.begin(), word.end(), [](char c) {
    return std::isdigit(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '+' && c != '-';
  });
  if (letters) return {begin, end, explainWord(word)};
  return {begin, end, fmt::format("{} is not a number in JSON; write it like -0.5 or 2e3", inQuotes(word))};
}

/// Explains a number that is incomplete (`-`, `5.`) or too large.
SyntaxError explainNumber(std::string_view text, std::size_t consumed, bool overflow) {
  std::size_t end = consumed;
  // The parser has read one character past the number, so that character is excluded.
  if (!isPartOfNumber(text[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && isPartOfNumber(text[begin - 1])) --begin;
  while (!overflow && end < text.size() && isWord(text[end])) ++end;
  const std::string_view word = text.substr(begin, end - begin);
  if (overflow)
    return {begin, end, fmt::format("{} is beyond the largest number there is, 1.8e308", inQuotes(word))};
  if (word.size() > 1 && std::isalpha(static_cast<unsigned char>(word[1])) != 0)
    return {begin, end, explainWord(word)};
  return {begin, end, fmt::format("{} is not a number in JSON; write it like -0.5 or 2e3", inQuotes(word))};
}

}  // namespace

std::size_t openingQuote(std::string_view text, std::size_t end) {
  // A quote after an odd number of backslashes is escaped and belongs to the string.
  for (std::size_t at = end; at-- > 0;) {
    if (text[at] != '"') continue;
    std::size_t slashes = 0;
    while (slashes < at && text[at - slashes - 1] == '\\') ++slashes;
    if (slashes % 2 == 0) return at;
  }
  return 0;
}

bool isPartOfNumber(char c) {
  return std::string_view("0123456789+-.eE").find(c) != std::string_view::npos;
}

SyntaxError explainSyntaxError(std::string_view text, std::size_t consumed, std::string_view what,
                               std::size_t openedAt) {
  consumed = std::min(consumed, text.size());
  const auto says = [&](std::string_view part) { return what.find(part) != std::string_view::npos; };
  const std::size_t last = consumed > 0 ? consumed - 1 : 0;
  if (text.empty() || says("unexpected end of input")) {
    if (openedAt == std::string_view::npos)
      return {consumed, consumed, "the text ends where a value is expected"};
    const auto line =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(openedAt), '\n') + 1;
    return {consumed, consumed,
            fmt::format("the text ends, but the '{}' of line {} is still open", text[openedAt], line)};
  }
  if (says("- invalid comment; missing closing")) {
    const std::size_t begin = std::min(text.rfind("/*"), last);
    return {begin, begin + 2, "comment without closing */"};
  }
  if (says("- invalid comment")) return {last, last + 1, "a comment begins with // or /*"};
  if (says("- invalid string: missing closing quote") || (says("- invalid string") && text[last] == '\n')) {
    const std::size_t begin = openingQuote(text, consumed);
    return {begin, begin + 1, "string without closing quote"};
  }
  if (says("- invalid string")) return {last, last + 1, explainString(what, text[last])};
  if (says("number overflow")) return explainNumber(text, consumed, true);
  if (says("- invalid number")) return explainNumber(text, consumed, false);
  if (says("- invalid")) return explainLiteral(text, last);
  std::size_t begin = last, end = consumed;
  if (says("unexpected string literal")) {
    begin = openingQuote(text, last);
  } else if (says("unexpected number literal")) {
    if (!isPartOfNumber(text[last])) --end;  // The parser has read one character past the number.
    for (begin = end; begin > 0 && isPartOfNumber(text[begin - 1]);) --begin;
  } else if (isWord(text[last])) {
    while (begin > 0 && isWord(text[begin - 1])) --begin;
  }
  return {begin, end, explainUnexpected(what, text, begin)};
}

}  // namespace simreel::scene
