#include "kernels/source/plain.hpp"

#include "kernels/source/files.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

namespace simreel::kernels {

namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

void blank(std::string& text, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < std::min(end, text.size()); ++i)
    if (text[i] != '\n') text[i] = ' ';
}

/// Calls `found` with the place of each whole word in the text without its comments.
template <class Found>
void eachWord(std::string_view code, std::string_view word, Found found) {
  for (std::size_t at = code.find(word); at != std::string_view::npos; at = code.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !partOfName(code[at - 1])) && (end >= code.size() || !partOfName(code[end])))
      found(at, end);
  }
}

/// ": packoffset(c0.y)": we lay constants out ourselves.
void blankPackOffsets(std::string& text, std::string_view code) {
  eachWord(code, "packoffset", [&](std::size_t at, std::size_t end) {
    std::size_t colon = at;
    while (colon > 0 && std::isspace(static_cast<unsigned char>(code[colon - 1])) != 0) --colon;
    const std::size_t close = code.find(')', end);
    if (colon == 0 || code[colon - 1] != ':' || close == std::string_view::npos) return;
    blank(text, colon - 1, close + 1);
  });
}

}  // namespace

bool partOfName(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::string withoutComments(std::string_view text) {
  std::string code(text);
  for (std::size_t at = 0; at + 1 < code.size(); ++at) {
    if (code[at] == '"') {
      const std::size_t end = code.find_first_of("\"\n", at + 1);
      if (end == std::string::npos) break;
      at = end;
    } else if (code[at] == '/' && code[at + 1] == '/') {
      const std::size_t end = std::min(code.find('\n', at), code.size());
      blank(code, at, end);
      at = end;
    } else if (code[at] == '/' && code[at + 1] == '*') {
      const std::size_t close = code.find("*/", at + 2);
      const std::size_t end = close == std::string::npos ? code.size() : close + 2;
      blank(code, at, end);
      at = end - 1;
    }
  }
  return code;
}

std::string plain(std::string_view original) {
  std::string text(original.starts_with(byteOrderMark) ? original.substr(byteOrderMark.size()) : original);
  for (std::size_t at = 0; at < text.size(); ++at)
    if (text[at] == '\r') {
      if (at + 1 < text.size() && text[at + 1] == '\n')
        text.erase(at, 1);
      else
        text[at] = ' ';
    }
  const std::string code = withoutComments(text);
  blankPackOffsets(text, code);
  for (const std::string_view word : {"unorm", "snorm"})
    eachWord(code, word, [&](std::size_t at, std::size_t end) {
      const std::size_t next = code.find_first_not_of(" \t", end);
      if (next != std::string::npos && code.compare(next, 5, "float") == 0) blank(text, at, end);
    });
  for (const std::string_view mark : {"#[compute]", "#[versions]"})
    if (const std::size_t at = code.find(mark); at != std::string::npos) blank(text, at, at + mark.size());
  return text;
}

std::string tooDeep(std::string_view text) {
  constexpr int maxNested = 200, maxRun = 2000;
  const std::string code = withoutComments(text);
  int nested = 0, run = 0, line = 1, otherwise = 0;
  std::string_view rest = code;
  for (std::size_t at = 0; at < code.size(); ++at) {
    const char c = code[at];
    if (c == '\n') ++line;
    if (c == '(' || c == '[' || c == '{') ++nested;
    if (c == ')' || c == ']' || c == '}') nested = std::max(0, nested - 1);
    if (c == ';' || c == '{' || c == '}') run = 0;
    if (std::string_view("+-*/%!~?&|^<>=.,").find(c) != std::string_view::npos) ++run;
    if (c == 'e' && rest.substr(at, 4) == "else" && (at == 0 || !partOfName(code[at - 1]))) ++otherwise;
    if (c == 'v' && rest.substr(at, 4) == "void") otherwise = 0;
    if (nested > maxNested)
      return fmt::format("brackets are nested more than {} deep in line {}", maxNested, line);
    if (run > 20 * maxRun || otherwise > maxRun)
      return fmt::format("the statement at line {} is too long for a compiler", line);
  }
  return {};
}

}  // namespace simreel::kernels
