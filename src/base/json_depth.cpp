#include "base/json_depth.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace simreel {

namespace {

/// Behind the text that begins with the quote at `at`.
std::size_t endOfText(std::string_view json, std::size_t at) {
  for (++at; at < json.size() && json[at] != '"'; ++at)
    if (json[at] == '\\') ++at;
  return at + 1;
}

/// Behind the comment at `at`, or behind the slash where none begins: no JSON has that.
std::size_t endOfComment(std::string_view json, std::size_t at) {
  const std::string_view start = json.substr(at, 2);
  if (start != "//" && start != "/*") return at + 1;
  const std::size_t end = start == "//" ? json.find('\n', at) : json.find("*/", at + 2);
  return end == std::string_view::npos ? json.size() : end + (start == "//" ? 1 : 2);
}

/// Calls `visit` with each bracket outside of texts and comments, until it returns false.
template <class Visit>
void eachBracket(std::string_view json, const Visit& visit) {
  for (std::size_t at = 0; at < json.size();) {
    const char c = json[at];
    if (c == '"') {
      at = endOfText(json, at);
    } else if (c == '/') {
      at = endOfComment(json, at);
    } else {
      if ((c == '[' || c == '{' || c == ']' || c == '}') && !visit(c == '[' || c == '{')) return;
      ++at;
    }
  }
}

}  // namespace

std::size_t jsonDepth(std::string_view json, std::size_t enough) {
  std::size_t depth = 0, deepest = 0;
  eachBracket(json, [&](bool opens) {
    if (opens) deepest = std::max(deepest, ++depth);
    if (!opens && depth > 0) --depth;
    return deepest < enough;
  });
  return deepest;
}

std::size_t jsonContainers(std::string_view json, std::size_t enough) {
  std::size_t count = 0;
  eachBracket(json, [&](bool opens) { return (count += opens ? 1 : 0) < enough; });
  return count;
}

void refuseDeepJson(std::string_view json) {
  if (jsonDepth(json) > mostJsonDepth)
    throw std::runtime_error(fmt::format("nested deeper than {} levels", mostJsonDepth));
}

}  // namespace simreel
