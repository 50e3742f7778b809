#include "kernels/source/plain.hpp"

#include "base/text.hpp"
#include "kernels/source/dialect.hpp"
#include "kernels/source/files.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace simreel::kernels {

namespace {

constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

void blank(std::string& text, std::size_t begin, std::size_t end) {
  for (std::size_t i = begin; i < std::min(end, text.size()); ++i)
    if (text[i] != '\n') text[i] = ' ';
}

/// Calls `found` with the range of each occurrence of a whole word in a text without comments.
template <class Found>
void eachWord(std::string_view code, std::string_view word, Found found) {
  for (std::size_t at = code.find(word); at != std::string_view::npos; at = code.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || !partOfName(code[at - 1])) && (end >= code.size() || !partOfName(code[end])))
      found(at, end);
  }
}

/// Replaces backslashes in "#include <util\\HlslCompat.h>", because glslang reads them as escapes.
void turnBackslashes(std::string& text, std::string_view code) {
  for (std::size_t at = code.find("include"); at != std::string_view::npos;
       at = code.find("include", at + 1)) {
    const std::size_t line = at == 0 ? 0 : code.rfind('\n', at - 1) + 1;
    const std::size_t sharp = code.find_first_not_of(" \t", line);
    if (code[sharp] != '#' || code.find_first_not_of(" \t", sharp + 1) != at) continue;
    for (std::size_t i = at; i + 1 < code.size() && code[i] != '\n'; ++i)
      if (code[i] == '\\' && code[i + 1] != '\n') text[i] = '/';
  }
}

/// Blanks ": packoffset(c0.y)", because the program lays out constants itself.
void blankPackOffsets(std::string& text, std::string_view code) {
  eachWord(code, "packoffset", [&](std::size_t at, std::size_t end) {
    std::size_t colon = at;
    while (colon > 0 && std::isspace(static_cast<unsigned char>(code[colon - 1])) != 0) --colon;
    const std::size_t close = code.find(')', end);
    if (colon == 0 || code[colon - 1] != ':' || close == std::string_view::npos) return;
    blank(text, colon - 1, close + 1);
  });
}

/// Truncates literals such as "0x1376312589U" to their lower 32 bits.
void shortenNumbers(std::string& text, std::string_view code) {
  for (std::size_t at = code.find("0x"); at != std::string_view::npos; at = code.find("0x", at + 2)) {
    std::size_t end = at + 2;
    while (end < code.size() && std::isxdigit(static_cast<unsigned char>(code[end])) != 0) ++end;
    const std::size_t digits = end - at - 2;
    if (digits <= 8 || (at > 0 && partOfName(code[at - 1]))) continue;
    blank(text, at, end - 10);
    text[end - 10] = '0';
    text[end - 9] = 'x';
  }
}

/// Blanks "const" in global declarations such as "const uint2 Resolution;". They are constants set by the
/// scene, but glslang would treat them as zero.
void blankConstOfGlobals(std::string& text, std::string_view code) {
  eachWord(code, "const", [&](std::size_t at, std::size_t end) {
    const auto open = std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(at), '{');
    if (open != std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(at), '}')) return;
    const std::size_t before = at == 0 ? std::string_view::npos : code.find_last_not_of(" \t\n\r", at - 1);
    const std::size_t stop = code.find_first_of("=;(){}", end);
    const bool first = before == std::string_view::npos || code[before] == ';' || code[before] == '}' ||
                       code.substr(0, at).find_last_of('\n') > before;
    if (first && stop != std::string_view::npos && code[stop] == ';' &&
        !code.substr(0, before + 1).ends_with("static"))
      blank(text, at, end);
  });
}

/// Returns the word after optional whitespace at `at`. Returns an empty text if there is no word.
std::string_view wordAt(std::string_view code, std::size_t& at) {
  at = std::min(code.find_first_not_of(" \t\n", at), code.size());
  const std::size_t begin = at;
  while (at < code.size() && partOfName(code[at])) ++at;
  return code.substr(begin, at - begin);
}

/// Adds declarations for loop variables. In Microsoft's older rules a variable declared in a loop header
/// exists until the end of the function, so "for (i = 0;" may follow "for (uint i = 0;". The later loop
/// gets a separate declaration.
class LoopVariables {
 public:
  static std::string declared(const std::string& text) {
    const std::string code = withoutComments(text);
    std::string result = text;
    std::vector<std::pair<std::size_t, std::string>> insertions;
    std::map<std::string, std::string, std::less<>> types;
    int depth = 0;
    for (std::size_t at = 0; at < code.size(); ++at) {
      if (code[at] == '{') ++depth;
      if (code[at] == '}' && --depth <= 0) types.clear();
      if (code.compare(at, 3, "for") != 0 || (at > 0 && partOfName(code[at - 1]))) continue;
      std::size_t next = std::min(code.find_first_not_of(" \t\n", at + 3), code.size());
      if (next >= code.size() || code[next] != '(') continue;
      const std::size_t head = ++next;
      const std::string_view first = wordAt(code, next);
      const std::string_view second = wordAt(code, next);
      if (!second.empty() && (first == "int" || first == "uint")) {
        types.emplace(second, first);
      } else if (const auto known = types.find(first);
                 known != types.end() && second.empty() && !declaredElsewhere(code, first, at)) {
        insertions.emplace_back(head, known->second + " ");
      }
    }
    for (auto one = insertions.rbegin(); one != insertions.rend(); ++one)
      result.insert(one->first, one->second);
    return result;
  }

 private:
  /// Returns true if the function declares the name outside loop headers and before position `before`.
  static bool declaredElsewhere(std::string_view code, std::string_view name, std::size_t before) {
    bool found = false;
    const std::size_t begin = code.rfind("\n}", before);
    const std::string_view function = code.substr(begin == std::string_view::npos ? 0 : begin,
                                                  before - (begin == std::string_view::npos ? 0 : begin));
    eachWord(function, name, [&](std::size_t at, std::size_t) {
      std::size_t end = at;
      while (end > 0 && std::isspace(static_cast<unsigned char>(function[end - 1])) != 0) --end;
      std::size_t start = end;
      while (start > 0 && partOfName(function[start - 1])) --start;
      const std::string_view type = function.substr(start, end - start);
      std::size_t open = start;
      while (open > 0 && std::isspace(static_cast<unsigned char>(function[open - 1])) != 0) --open;
      const bool inLoop =
          open > 0 && function[open - 1] == '(' && function.substr(0, open - 1).ends_with("for");
      const bool spaced =
          open > 1 && function[open - 1] == '(' && function.substr(0, open - 1).ends_with("for ");
      if ((type == "int" || type == "uint") && !inLoop && !spaced) found = true;
    });
    return found;
  }
};

/// Expands "m._m00_m10_m20" to "float3(m._m00, m._m10, m._m20)", because glslang uses only the first
/// element.
std::string withMatrixElements(const std::string& text) {
  const std::string code = withoutComments(text);
  std::string result = text;
  for (std::size_t at = code.rfind("._"); at != std::string::npos && at > 0;
       at = code.rfind("._", at - 1)) {
    const bool zeroBased = at + 2 < code.size() && code[at + 2] == 'm';
    const std::size_t length = zeroBased ? 4 : 3;
    std::vector<std::string> elements;
    std::size_t end = at + 1;
    const auto isElement = [&] {
      const std::string one = code.substr(end, length);
      return one.size() == length && one[0] == '_' && (!zeroBased || one[1] == 'm') &&
             isDigit(one[length - 2]) && isDigit(one[length - 1]);
    };
    for (; isElement(); end += length) elements.push_back(code.substr(end, length));
    if (elements.size() < 2 || elements.size() > 4 || (end < code.size() && partOfName(code[end])))
      continue;
    std::size_t begin = at;
    while (begin > 0 && (partOfName(code[begin - 1]) || code[begin - 1] == '.')) --begin;
    if (begin == at || (begin > 0 && (code[begin - 1] == ']' || code[begin - 1] == ')'))) continue;
    const std::size_t next = code.find_first_not_of(" \t", end);
    if (next != std::string::npos && code[next] == '=' && code.compare(next, 2, "==") != 0)
      continue;  // The target of an assignment is not expanded.
    const std::string matrix = code.substr(begin, at - begin);
    std::string vector = fmt::format("float{}(", elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i)
      vector += (i == 0 ? "" : ", ") + matrix + "." + elements[i];
    result.replace(begin, end - begin, vector + ")");
  }
  return result;
}

/// Renames "sampler" to "sampler_" where it is the name of a variable, which OpenGL permits. Vulkan's GLSL
/// and HLSL have a type of that name.
std::string withSamplersRenamed(std::string text) {
  const std::string code = withoutComments(text);
  std::vector<std::size_t> ends;
  bool type = false;
  eachWord(code, "sampler", [&](std::size_t, std::size_t end) {
    const std::size_t next = code.find_first_not_of(" \t\n", end);
    type = type || (next != std::string::npos && partOfName(code[next]));
    ends.push_back(end);
  });
  if (type) return text;
  for (auto end = ends.rbegin(); end != ends.rend(); ++end) text.insert(*end, "_");
  return text;
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
  turnBackslashes(text, code);
  blankPackOffsets(text, code);
  shortenNumbers(text, code);
  if (code.find("#version") == std::string::npos) blankConstOfGlobals(text, code);
  for (const std::string_view word : {"unorm", "snorm"})
    eachWord(code, word, [&](std::size_t at, std::size_t end) {
      const std::size_t next = code.find_first_not_of(" \t", end);
      if (next != std::string::npos && code.compare(next, 5, "float") == 0) blank(text, at, end);
    });
  for (std::size_t at = code.find("[[vk::"); at != std::string::npos; at = code.find("[[vk::", at + 1))
    if (const std::size_t end = code.find("]]", at); end != std::string::npos) blank(text, at, end + 2);
  for (const std::string_view mark : {"#[compute]", "#[versions]"})
    if (const std::size_t at = code.find(mark); at != std::string::npos) blank(text, at, at + mark.size());
  const bool glsl = code.find("#version") != std::string::npos;
  return withMatrixElements(LoopVariables::declared(withSamplersRenamed(glsl ? text : dialect(text))));
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
