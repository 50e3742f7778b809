#pragma once
#include "base/text.hpp"
#include "sim/automata/rule/notation.hpp"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace simreel::sim {

/// Maximum number of ranges in a list of counts. It is limited because the ranges are written into a
/// kernel's source.
inline constexpr std::size_t maxRanges = 200;

inline char upperLetter(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

inline int hexValue(char c) {
  const char upper = upperLetter(c);
  return isDigit(upper) ? upper - '0' : upper >= 'A' && upper <= 'F' ? upper - 'A' + 10 : -1;
}

/// Reads a notation from left to right and keeps the first error.
class NotationReader {
 public:
  NotationReader(std::string_view text, const char* advice) : text_(text), advice_(advice) {}

  [[nodiscard]] bool good() const { return problem_.message.empty(); }
  /// Returns the current character in upper case; 0 at the end.
  [[nodiscard]] char here() const { return at_ < text_.size() ? upperLetter(text_[at_]) : '\0'; }
  [[nodiscard]] std::size_t at() const { return at_; }
  void moveTo(std::size_t at) { at_ = at; }

  /// Skips an expected character, in either case. If it is missing, sets the error.
  void expect(char wanted) {
    if (!good()) return;
    if (here() != wanted) {
      wrong(at_, fmt::format("'{}' is expected {}; {}", wanted, at_ < text_.size() ? "here" : "at the end",
                             advice_));
      return;
    }
    ++at_;
  }
  void number(const char* what, int min, int max, int& value) {
    if (!good()) return;
    start_ = at_;
    problem_ = takeRuleNumber(text_, at_, what, min, max, value);
  }
  /// Reads two limits such as "34..58" or "34,45", each up to `max`.
  void limits(std::string_view between, const char* what, int max, std::vector<CountRange>& counts) {
    counts.assign(1, {0, 0});
    auto& [low, high] = counts[0];
    number(what, 0, max, low);
    const std::size_t first = start_;
    for (const char c : between) expect(c);
    number(what, 0, max, high);
    if (good() && low > high)
      wrong(first, fmt::format("{} to {}: the lower limit is above the upper one", low, high));
  }
  /// Reads a list of ranges such as "2-3,8", which may be empty. Does not consume a comma that is not
  /// followed by a number.
  void list(const char* what, int max, std::vector<CountRange>& counts) {
    counts.clear();
    const std::size_t start = at_;
    while (good() && isDigit(here())) {
      CountRange range{0, 0};
      number(what, 0, max, range.low);
      const std::size_t first = start_;
      range.high = range.low;
      if (here() == '-') {
        ++at_;
        number(what, 0, max, range.high);
      }
      if (good() && range.low > range.high)
        wrong(first,
              fmt::format("{} to {}: the lower limit is above the upper one", range.low, range.high));
      counts.push_back(range);
      if (here() == ',' && at_ + 1 < text_.size() && isDigit(text_[at_ + 1])) ++at_;
    }
    join(counts);
    if (counts.size() > maxRanges)
      wrong(start, fmt::format("{} ranges of counts; at most {} are allowed", counts.size(), maxRanges));
  }
  /// Reads hexadecimal digits.
  [[nodiscard]] std::vector<int> hexDigits() {
    std::vector<int> digits;
    for (; at_ < text_.size() && hexValue(text_[at_]) >= 0; ++at_) digits.push_back(hexValue(text_[at_]));
    return digits;
  }
  NeighbourShape cyclicShape() {
    if (!good()) return NeighbourShape::moore;
    const char letter = here();
    if (letter != 'M' && letter != 'N') wrong(at_, "the neighbourhood is M (Moore) or N (von Neumann)");
    ++at_;
    return letter == 'N' ? NeighbourShape::vonNeumann : NeighbourShape::moore;
  }
  void end() {
    if (good() && at_ < text_.size())
      wrong(at_, fmt::format("{} after the end of the rule; {}", shownCharacter(text_, at_), advice_));
  }
  void wrong(std::size_t at, std::string message) {
    if (good()) problem_ = {at, std::move(message)};
  }
  [[nodiscard]] const RuleProblem& problem() const { return problem_; }

 private:
  /// Sorts ranges and merges adjacent ones.
  static void join(std::vector<CountRange>& counts) {
    std::ranges::sort(counts, {}, &CountRange::low);
    std::vector<CountRange> joined;
    for (const CountRange& range : counts)
      if (!joined.empty() && range.low <= joined.back().high + 1)
        joined.back().high = std::max(joined.back().high, range.high);
      else
        joined.push_back(range);
    counts = std::move(joined);
  }

  std::string_view text_;
  const char* advice_;
  std::size_t at_ = 0, start_ = 0;
  RuleProblem problem_;
};

/// Reads the neighbourhood after the final N of a Larger than Life rule with `states` states.
void readNeighbourhood(NotationReader& reader, WideRule& rule, int states);

}  // namespace simreel::sim
