#include "sim/polygons/words.hpp"

#include "base/text.hpp"

#include <algorithm>
#include <charconv>
#include <limits>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

bool isGap(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

template <class Number>
std::optional<Number> parsedNumber(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::invalid_argument || end != word.data() + word.size()) return std::nullopt;
  if (error == std::errc()) return value;
  // The number is out of range; this distinguishes underflow to 0 from overflow.
  const auto exponent = word.find_first_of("eE");
  const bool small = exponent == std::string_view::npos ? word.find_first_of("123456789") > word.find('.')
                                                        : word.substr(exponent + 1).starts_with('-');
  return small ? Number{0} : std::numeric_limits<Number>::infinity();
}

}  // namespace

std::string_view takeWord(std::string_view& line) {
  std::size_t first = 0;
  while (first < line.size() && isGap(line[first])) ++first;
  std::size_t end = first;
  while (end < line.size() && !isGap(line[end])) ++end;
  const std::string_view word = line.substr(first, end - first);
  line.remove_prefix(end);
  return word;
}

std::string_view withoutBlanks(std::string_view text) {
  while (!text.empty() && isGap(text.front())) text.remove_prefix(1);
  while (!text.empty() && isGap(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view withoutComment(std::string_view line, bool ofNames) {
  for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1))
    if (!ofNames || at == 0 || isGap(line[at - 1])) return line.substr(0, at);
  return line;
}

std::optional<float> floatIn(std::string_view word) {
  return parsedNumber<float>(word);
}

std::optional<double> doubleIn(std::string_view word) {
  return parsedNumber<double>(word);
}

bool TextLines::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
  line = rest_.substr(0, end);
  const std::size_t ending = rest_.substr(end).starts_with("\r\n") ? 2 : 1;
  rest_.remove_prefix(std::min(end + ending, rest_.size()));
  ++number_;
  return true;
}

std::string inQuotes(std::string_view line) {
  constexpr std::size_t maximum = 60;
  return fmt::format("\"{}\"", oneLine(withoutBlanks(line).substr(0, maximum)));
}

}  // namespace simreel::sim
