#include "kernels/compile/messages.hpp"

#include "kernels/source/plain.hpp"
#include "scene/json/words.hpp"

#include <algorithm>
#include <charconv>
#include <functional>
#include <sstream>

#include <fmt/format.h>

namespace simreel::kernels {

namespace {

constexpr std::string_view error = "ERROR: ";

std::string trimmed(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == ':')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\r')) text.remove_suffix(1);
  return std::string(text);
}

/// Parses "name:line: 'token' : message", the text after "ERROR: ". `count`: number of files. The line is 0
/// if the text has no line number.
Mistake located(std::string_view rest, std::size_t count) {
  Mistake mistake;
  const std::size_t first = rest.find(':');
  const std::size_t second = first == std::string_view::npos ? first : rest.find(':', first + 1);
  if (second == std::string_view::npos) return {0, 0, "", trimmed(rest)};
  int line = 0;
  const char* end = rest.data() + second;
  const auto read = std::from_chars(rest.data() + first + 1, end, line);
  if (read.ec != std::errc() || read.ptr != end) return {0, 0, "", trimmed(rest)};
  mistake.file = fileNumber(rest.substr(0, first), count);
  mistake.line = line;
  std::string_view message = rest.substr(second + 1);
  const std::size_t quote = message.find('\'');
  const std::size_t close = message.find("' : ");
  if (quote != std::string_view::npos && quote <= 1 && close != std::string_view::npos) {
    mistake.token = std::string(message.substr(quote + 1, close - quote - 1));
    message.remove_prefix(close + 4);
  }
  mistake.message = trimmed(message);
  return mistake;
}

/// Replaces some of glslang's messages by clearer ones.
void reword(Mistake& mistake) {
  struct Wording {
    std::string_view theirs, ours;
  };
  static constexpr Wording wordings[] = {
      {"undeclared identifier", "is not declared"},
      {"unknown variable", "is not declared"},
      {"no matching overloaded function found", "has no function with these arguments"},
  };
  const bool named = !mistake.token.empty();
  if (mistake.message.find("can't modify a uniform") != std::string::npos) {
    mistake.message = "a kernel cannot write to a constant";
    return;
  }
  if (mistake.token.starts_with("GL_EXT_ray") || mistake.token.starts_with("GL_NV_ray")) {
    mistake.message = fmt::format("{}: OpenGL has no ray queries", scene::inQuotes(mistake.token));
    return;
  }
  if (mistake.message.find("compute_shader_derivatives") != std::string::npos) {
    mistake.message = fmt::format(
        "{}: a compute shader has no neighbouring pixels to take a derivative of; compute the difference "
        "yourself",
        scene::inQuotes(mistake.token));
    return;
  }
  if (mistake.message.find("block instance name redefinition") != std::string::npos) {
    mistake.token = mistake.token.substr(0, mistake.token.find('@'));
    mistake.message =
        fmt::format("{} is declared twice; a file that is included twice needs \"#pragma once\"",
                    scene::inQuotes(mistake.token));
    return;
  }
  if (mistake.token.starts_with("Interlocked") && mistake.message.find("no matching overloaded") == 0) {
    mistake.message = fmt::format(
        "{} has no function with these arguments: atomic operations are for int and uint, in buffers, "
        "textures "
        "and groupshared variables",
        scene::inQuotes(mistake.token));
    return;
  }
  for (const Wording& wording : wordings)
    if (mistake.message.find(wording.theirs) != std::string::npos && named) {
      mistake.message = fmt::format("{} {}", scene::inQuotes(mistake.token), wording.ours);
      return;
    }
  if (named) mistake.message = fmt::format("{}: {}", scene::inQuotes(mistake.token), mistake.message);
}

/// Builds an error from "f(i1; calling g(i1;", the text after glslang's message about recursion.
Mistake recursion(std::string_view calls, const Files& files) {
  const std::string name = trimmed(calls.substr(0, calls.find('(')));
  const std::string code = withoutComments(files.text(0));
  std::size_t at = 0;
  for (at = code.find(name + "("); at != std::string::npos && at > 0 && partOfName(code[at - 1]);)
    at = code.find(name + "(", at + 1);
  const int line = at == std::string::npos
                       ? 1
                       : 1 + static_cast<int>(std::count(
                                 code.begin(), code.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
  return {0, line, name, fmt::format("{} calls itself, which shaders cannot do", scene::inQuotes(name))};
}

/// Returns the failed include that an error refers to, with the reason. Returns nullptr for other errors.
const std::pair<std::string, std::string>* failedInclude(
    const Mistake& mistake, const std::vector<std::pair<std::string, std::string>>& failed) {
  if (mistake.message.find("include") == std::string::npos &&
      mistake.token.find("include") == std::string::npos)
    return nullptr;
  for (const auto& one : failed)
    if (mistake.message.find(one.first) != std::string::npos ||
        mistake.token.find(one.first) != std::string::npos)
      return &one;
  return nullptr;
}

/// Returns the source line of an error.
std::string_view lineOf(const Mistake& mistake, const Files& files) {
  std::string_view text = files.text(mistake.file);
  for (int line = 1; line < mistake.line && !text.empty(); ++line)
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text.substr(0, text.find('\n'));
}

/// Removes errors that are consequences of other errors. Rewords errors about types that glslang does not
/// support.
void keepCauses(std::vector<Mistake>& mistakes, const Files& files) {
  for (Mistake& mistake : mistakes)
    for (const std::string_view type : {"RaytracingAccelerationStructure", "RayQuery", "RayDesc"})
      if (mistake.message.ends_with(": Expected") &&
          lineOf(mistake, files).find(type) != std::string_view::npos) {
        mistake.token = type;
        mistake.message = fmt::format("{}: OpenGL has no ray queries", scene::inQuotes(type));
      }
  const auto follows = [](const Mistake& one) {
    return one.message.find("cannot be preceded by another token") != std::string::npos ||
           one.message.find("extra tokens -- expected newline") != std::string::npos ||
           one.message.find("missing #endif") != std::string::npos;
  };
  if (std::any_of(mistakes.begin(), mistakes.end(), std::not_fn(follows))) std::erase_if(mistakes, follows);
}

}  // namespace

std::size_t fileNumber(std::string_view name, std::size_t count) {
  std::size_t number = 0;
  const auto read = std::from_chars(name.data(), name.data() + name.size(), number);
  return read.ec == std::errc() && read.ptr == name.data() + name.size() && number < count ? number : 0;
}

std::vector<Mistake> errorsInLog(std::string_view log, std::size_t files) {
  std::vector<Mistake> mistakes;
  std::istringstream lines{std::string(log)};
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(error))
      mistakes.push_back(located(std::string_view(line).substr(error.size()), files));
  return mistakes;
}

std::vector<Mistake> rewordedErrors(std::string_view log, const Files& files,
                                    const std::vector<std::pair<std::string, std::string>>& failed,
                                    const Unit& unit) {
  constexpr std::size_t maximum = 20;
  if (log.find(noEntry) != std::string_view::npos)
    return {{0, unit.line, unit.entry,
             fmt::format("the file has no function {}", scene::inQuotes(unit.entry))}};
  std::vector<Mistake> mistakes;
  std::istringstream lines{std::string(log)};
  for (std::string line; std::getline(lines, line) && mistakes.size() < maximum;) {
    if (!line.starts_with(error)) continue;
    Mistake mistake = located(std::string_view(line).substr(error.size()), files.count());
    if (mistake.message.find("compilation errors") != std::string::npos ||
        mistake.message.find("compilation terminated") != std::string::npos)
      continue;
    if (mistake.message.find("Recursion detected") != std::string::npos) {
      std::getline(lines, line);
      return {recursion(line, files)};
    }
    if (const auto* include = failedInclude(mistake, failed)) {
      mistake.token = include->first;
      mistake.message = include->second;
      return {mistake};  // The other errors are consequences of this one.
    }
    reword(mistake);
    const bool known = std::any_of(mistakes.begin(), mistakes.end(), [&](const Mistake& other) {
      return other.file == mistake.file && other.line == mistake.line && other.message == mistake.message;
    });
    if (!known) mistakes.push_back(std::move(mistake));
  }
  keepCauses(mistakes, files);
  // The HLSL parser repeats ": Expected" for every grammar level above an error.
  const auto expected = [](const Mistake& one) { return one.message.ends_with(": Expected"); };
  if (std::any_of(mistakes.begin(), mistakes.end(), std::not_fn(expected)))
    std::erase_if(mistakes, expected);
  else if (!mistakes.empty())
    mistakes.resize(1);
  if (mistakes.empty())
    mistakes.push_back({0, unit.line, unit.entry, "the compiler gives no reason for refusing this"});
  return mistakes;
}

}  // namespace simreel::kernels
