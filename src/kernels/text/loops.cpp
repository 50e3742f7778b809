#include "kernels/text/loops.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

namespace simreel::kernels {

namespace {

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(' ');
  return begin == std::string_view::npos ? std::string_view() : text.substr(begin);
}

/// Increments of a line `for (start; test; increments)`.
struct Increments {
  std::size_t at = 0;  ///< index in the line at which the first increment begins
  std::vector<std::string_view> all;
};

Increments incrementsOf(std::string_view line) {
  Increments found;
  if (!trimmed(line).starts_with("for (") || line.back() != ')') return found;
  const std::size_t begin = line.rfind("; ");
  if (begin == std::string_view::npos) return found;
  found.at = begin + 2;
  std::string_view rest = line.substr(found.at, line.size() - found.at - 1);
  while (!rest.empty()) {
    const std::size_t comma = rest.find(", ");
    const std::string_view one = rest.substr(0, comma);
    found.all.push_back(one);
    rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 2);
  }
  return found;
}

bool beginsLoop(std::string_view text) {
  return text.starts_with("for (") || text.starts_with("while (") || text == "do";
}

/// Positions of lines in a loop's body.
struct Body {
  std::size_t end = 0;                 ///< line of the closing brace
  std::vector<std::size_t> continues;  ///< indices of the lines `continue;` of this loop, but not of nested
                                       ///< loops
};

/// Returns the body whose opening brace is in line `open`.
Body bodyAt(const std::vector<std::string_view>& lines, std::size_t open) {
  Body body;
  std::vector<bool> loops;  // one entry for each open brace; true if it belongs to a loop
  for (std::size_t i = open; i < lines.size(); ++i) {
    const std::string_view text = trimmed(lines[i]);
    if (text.starts_with("{")) loops.push_back(beginsLoop(trimmed(lines[i - 1])));
    if (text.starts_with("}")) {
      loops.pop_back();
      body.end = i;
      if (loops.empty()) return body;
    }
    if (text.starts_with("continue;") && std::count(loops.begin(), loops.end(), true) == 1)
      body.continues.push_back(i);
  }
  return body;
}

}  // namespace

void moveIncrements(std::string& glsl) {
  std::vector<std::string_view> lines;
  for (std::string_view rest = glsl; !rest.empty();) {
    const std::size_t end = rest.find('\n');
    lines.push_back(rest.substr(0, end));
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
  }
  std::vector<std::string> before(lines.size());  // statements to insert before each line
  std::string out;
  out.reserve(glsl.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    out += before[i];
    const Increments increments = incrementsOf(lines[i]);
    if (increments.all.size() < 2) {
      out.append(lines[i]).push_back('\n');
      continue;
    }
    const Body body = bodyAt(lines, i + 1);
    out.append(lines[i].substr(0, increments.at - 1)).append(")\n");
    const auto put = [&](std::size_t line, std::size_t indent) {
      for (const std::string_view one : increments.all)
        before[line].append(indent, ' ').append(one).append(";\n");
    };
    for (const std::size_t line : body.continues) put(line, lines[line].find('c'));
    put(body.end, lines[body.end].find('}') + 4);
  }
  glsl = std::move(out);
}

}  // namespace simreel::kernels
