#include "sim/life/rule.hpp"

#include "base/text.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr const char* advice = "write a rule as \"B3/S23\" (or \"23/3\", survival first)";
constexpr const char* known =
    "only numbers of living neighbours among eight, for cells of two states, are known";

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool isLetter(char c) {
  return lower(c) >= 'a' && lower(c) <= 'z';
}

/// Reads digits up to the first character that is none.
LifeRuleProblem takeDigits(std::string_view text, std::size_t& at, int& mask) {
  mask = 0;
  for (; at < text.size() && isDigit(text[at]); ++at) {
    if (text[at] == '9') return {at, fmt::format("a cell has 8 neighbours, not 9; {}", advice)};
    const int bit = 1 << (text[at] - '0');
    if ((mask & bit) != 0) return {at, fmt::format("{} is there twice; {}", text[at], advice)};
    mask |= bit;
  }
  return {};
}

/// What is wrong where a number or a slash should stand.
LifeRuleProblem notANumber(std::string_view text, std::size_t at) {
  if (at == text.size()) return {at, fmt::format("a slash is missing; {}", advice)};
  const char c = text[at];
  return {at, fmt::format("'{}' is not a number of neighbours, 0 to 8; {}",
                          c >= ' ' && c <= '~' ? std::string(1, c) : std::string("?"), advice)};
}

/// Numbers behind the letters b and s, in either order; the slash between them may be missing.
LifeRuleProblem takeLettered(std::string_view text, LifeRule& rule) {
  std::size_t at = 0;
  int masks[2] = {};  // born, survives
  bool seen[2] = {};
  for (int part = 0; part < 2; ++part) {
    if (part == 1 && at < text.size() && text[at] == '/') ++at;
    const char wanted = part == 0 ? '?' : seen[0] ? 'S' : 'B';
    const char letter = at < text.size() ? lower(text[at]) : '\0';
    if (part == 1 && letter != lower(wanted)) {
      if (at < text.size() && text[at - 1] != '/') return notANumber(text, at);
      return {at, fmt::format("{} {} is missing; {}", wanted == 'S' ? "an" : "a", wanted, advice)};
    }
    const std::size_t which = letter == 's' ? 1 : 0;
    seen[which] = true;
    ++at;
    if (auto problem = takeDigits(text, at, masks[which]); !problem.message.empty()) return problem;
  }
  if (at < text.size() && text[at] == '/') return {at, fmt::format("a second slash; {}", advice)};
  if (at < text.size()) return notANumber(text, at);
  rule = {masks[0], masks[1]};
  return {};
}

LifeRuleProblem takeNumbers(std::string_view text, LifeRule& rule) {
  std::size_t at = 0;
  if (auto problem = takeDigits(text, at, rule.survives); !problem.message.empty()) return problem;
  if (at == text.size() || text[at] != '/') return notANumber(text, at);
  ++at;
  if (auto problem = takeDigits(text, at, rule.born); !problem.message.empty()) return problem;
  if (at < text.size() && text[at] == '/') return {at, fmt::format("a second slash; {}", advice)};
  if (at < text.size()) return notANumber(text, at);
  return {};
}

/// What a rule is that other programs know and this one does not: as "a rule of ..."; null: a mistake.
/// Notations of Golly's help and of the LifeWiki.
const char* otherKind(std::string_view text, std::size_t at) {
  std::string low(text);
  std::transform(low.begin(), low.end(), low.begin(), lower);
  const auto starts = [&](std::string_view word) { return low.starts_with(word); };
  const auto before = [&](char letter) { return low.size() > 1 && low[0] == letter && isDigit(low[1]); };
  if (before('r') && low.find(',') != std::string::npos)
    return "a rule of Larger than Life, which looks beyond the eight neighbours";
  if (before('w')) return "one of Wolfram's rules of a single row";
  if (before('m') || starts("margolus")) return "a rule of blocks (Margolus)";
  if (starts("map")) return "a rule that lists every neighbourhood (MAP)";
  if (std::count(low.begin(), low.end(), '/') > 1) return "a rule of more than two states (Generations)";
  for (const char* word : {"history", "super", "investigator", "wireworld", "jvn", "nobili", "hutton",
                           "codd", "langton", "rainbow"})
    if (low.find(word) != std::string::npos) return "a rule of more than two states";
  if (low[0] != 'b' && low[0] != 's' && !isDigit(low[0]) && low[0] != '/') return nullptr;
  const char c = at < low.size() ? low[at] : '\0';
  if (c == 'v' && at + 1 == low.size()) return "a rule of four neighbours (von Neumann)";
  if (c == 'h' && at + 1 == low.size()) return "a rule of six neighbours (hexagonal)";
  if (c == 'l' && at + 1 == low.size()) return "a rule of triangles";
  if (at > 0 && c != '\0' && std::string_view("-cekainyqjrtwz").find(c) != std::string_view::npos)
    return "a rule that asks where neighbours lie, not only how many live (Hensel's notation)";
  return nullptr;
}

}  // namespace

std::string LifeRule::text() const {
  std::string result = "B";
  for (int n = 0; n <= 8; ++n)
    if ((born >> n & 1) != 0) result += static_cast<char>('0' + n);
  result += "/S";
  for (int n = 0; n <= 8; ++n)
    if ((survives >> n & 1) != 0) result += static_cast<char>('0' + n);
  return result;
}

LifeRuleProblem parseLifeRule(std::string_view text, LifeRule& rule) {
  if (text.empty()) return {0, fmt::format("the rule is empty; {}", advice)};
  LifeRule read;
  const char first = lower(text[0]);
  LifeRuleProblem problem;
  if (text == "Life" || text == "life")
    read = LifeRule{};
  else if (first == 'b' || first == 's')
    problem = takeLettered(text, read);
  else
    problem = takeNumbers(text, read);
  if (problem.message.empty()) {
    rule = read;
    return {};
  }
  if (const char* kind = otherKind(text, problem.at))
    problem.message = fmt::format("this is {}; {}", kind, known);
  else if (isLetter(text[0]) && first != 'b' && first != 's')
    problem.message = fmt::format("this names a rule that is not known; {}", advice);
  return problem;
}

}  // namespace simreel::sim
