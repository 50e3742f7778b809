#include "sim/life_rule.hpp"

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr const char* advice = "write a rule as \"B3/S23\" (or \"23/3\", survival first)";

bool isLetter(char c, char lower) {
  return c == lower || c == lower - 'a' + 'A';
}

/// Reads digits up to the end or a slash.
LifeRuleProblem takeDigits(std::string_view text, std::size_t& at, int& mask) {
  mask = 0;
  for (; at < text.size() && text[at] != '/'; ++at) {
    const char c = text[at];
    if (c == '9') return {at, fmt::format("a cell has 8 neighbours, not 9; {}", advice)};
    if (c < '0' || c > '8')
      return {at, fmt::format("'{}' is not a number of neighbours, 0 to 8; {}",
                              c >= ' ' && c <= '~' ? std::string(1, c) : std::string("?"), advice)};
    const int bit = 1 << (c - '0');
    if ((mask & bit) != 0) return {at, fmt::format("{} is there twice; {}", c, advice)};
    mask |= bit;
  }
  return {};
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
  const bool letters = isLetter(text[0], 'b');
  std::size_t at = letters ? 1 : 0;
  int first = 0;
  int second = 0;
  if (auto problem = takeDigits(text, at, first); !problem.message.empty()) return problem;
  if (at == text.size()) return {at, fmt::format("a slash is missing; {}", advice)};
  ++at;
  if (letters) {
    if (at == text.size() || !isLetter(text[at], 's'))
      return {at, fmt::format("an S is missing; {}", advice)};
    ++at;
  }
  if (auto problem = takeDigits(text, at, second); !problem.message.empty()) return problem;
  if (at != text.size())
    return {at, fmt::format("a second slash: only cells of two states are known; {}", advice)};
  rule = letters ? LifeRule{first, second} : LifeRule{second, first};
  return {};
}

}  // namespace simreel::sim
