#include "base/text.hpp"
#include "sim/automata/rule/notation.hpp"

#include <cstdint>
#include <vector>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr std::string_view base64 = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Returns the cells (of nine, row by row) that index the bits of a map with this number of base64 digits;
/// the first cell is the most significant bit. For hexagonal maps, Golly 3.3 puts the row below first. Its
/// help does not mention that, and rules by counts do not reveal it, but maps that copy a single cell move
/// patterns accordingly.
std::vector<unsigned> cellsOfMap(std::size_t digits) {
  if (digits == 86) return {0, 1, 2, 3, 4, 5, 6, 7, 8};
  if (digits == 22) return {7, 8, 3, 4, 5, 0, 1};
  if (digits == 6) return {1, 3, 4, 5, 7};
  return {};
}

}  // namespace

RuleProblem parseMap(std::string_view text, CellRule& rule) {
  constexpr std::size_t first = 3;  // offset of the digits, after "MAP"
  std::size_t at = first;
  // A slash is also a base64 digit, so the total length determines where the digits end. After them, only a
  // number of states such as "/3" may follow.
  std::size_t end = text.size();
  for (const std::size_t digits : {std::size_t{86}, std::size_t{22}, std::size_t{6}}) {
    const std::size_t stop = first + digits;
    if (text.size() < stop) continue;
    const std::string_view rest = text.substr(stop);
    if (rest.empty() || rest.starts_with("==") || (rest[0] == '/' && rest.size() <= 4)) {
      end = stop;
      break;
    }
  }
  std::vector<bool> bits;
  for (; at < end; ++at) {
    const auto digit = base64.find(text[at]);
    if (digit == std::string_view::npos)
      return {at, fmt::format("{} is not a digit of base64", shownCharacter(text, at))};
    for (int bit = 5; bit >= 0; --bit) bits.push_back((digit >> bit & 1U) != 0);
  }
  const std::vector<unsigned> cells = cellsOfMap(end - first);
  if (cells.empty())
    return {first, fmt::format("MAP is followed by 86, 22 (hexagonal) or 6 (von Neumann) digits of base64, "
                               "not by {}",
                               end - first)};
  if (text.substr(at).starts_with("==")) at += 2;
  int states = 2;
  if (at < text.size() && text[at] == '/') {
    ++at;
    if (RuleProblem problem = takeRuleNumber(text, at, "the number of states", 2, 256, states);
        !problem.message.empty())
      return problem;
  }
  if (at < text.size()) return {at, fmt::format("{} after the end of the rule", shownCharacter(text, at))};
  rule = CellRule();
  rule.family = CellRule::Family::map;
  rule.states = states;
  for (unsigned i = 0; i < 512; ++i) {
    std::size_t index = 0;
    for (const unsigned cell : cells) index = index * 2 + (i >> cell & 1U);
    if (bits[index]) rule.map[i / 32] |= 1U << (i % 32);
  }
  rule.name = std::string(text.substr(0, end)) + (states > 2 ? fmt::format("/{}", states) : "");
  return {};
}

RuleProblem parseWolfram(std::string_view text, CellRule& rule) {
  std::size_t at = 1;
  int number = 0;
  if (RuleProblem problem = takeRuleNumber(text, at, "the rule's number", 0, 255, number);
      !problem.message.empty())
    return problem;
  if (at < text.size()) return {at, fmt::format("{} after the end of the rule", shownCharacter(text, at))};
  if (number % 2 != 0)
    return {
        1, fmt::format(
               "{} is odd: all rows would be born at once; Wolfram's rules of a row have even numbers here",
               number)};
  rule = CellRule();
  rule.family = CellRule::Family::map;
  for (unsigned i = 0; i < 512; ++i) {
    const unsigned above = (i & 1U) * 4 + (i >> 1 & 1U) * 2 + (i >> 2 & 1U);
    if ((i >> 4 & 1U) != 0 || (static_cast<unsigned>(number) >> above & 1U) != 0)
      rule.map[i / 32] |= 1U << (i % 32);
  }
  rule.name = fmt::format("W{}", number);
  return {};
}

}  // namespace simreel::sim
