#include "base/text.hpp"
#include "sim/automata/rule/arrangements.hpp"
#include "sim/automata/rule/notation.hpp"

#include <array>
#include <bit>
#include <optional>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr const char* countsAdvice = "write a rule as \"B3/S23\" (or \"23/3\", survival first)";

char lowerLetter(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

/// Bit masks of the neighbours among nine cells.
constexpr unsigned aroundMoore = 0x1EF, aroundFour = 0xAA, aroundSix = 0x1EF & ~(1U << 2 | 1U << 6);

unsigned around(NeighbourShape shape) {
  return shape == NeighbourShape::vonNeumann  ? aroundFour
         : shape == NeighbourShape::hexagonal ? aroundSix
                                              : aroundMoore;
}

/// Allowed arrangements (bits of arrangementLetters) for each number of neighbours.
using Counts = std::array<int, 9>;

class CountsReader {
 public:
  explicit CountsReader(std::string_view text) : text_(text) {
    if (text.size() < 2) return;
    const char last = lowerLetter(text.back());
    if (last == 'v') shape_ = NeighbourShape::vonNeumann;
    if (last == 'h') shape_ = NeighbourShape::hexagonal;
    if (shape_ != NeighbourShape::moore) text_.remove_suffix(1);
  }

  RuleProblem read(CellRule& rule) {
    const char first = text_.empty() ? '\0' : lowerLetter(text_[0]);
    RuleProblem problem = first == 'b' || first == 's' ? lettered() : numbers();
    if (problem.message.empty() && at_ < text_.size()) problem = states();
    if (problem.message.empty()) rule = made();
    return problem;
  }

 private:
  [[nodiscard]] int maxCount() const { return std::popcount(around(shape_)); }
  [[nodiscard]] bool slash() const {
    return at_ < text_.size() && (text_[at_] == '/' || text_[at_] == '_');
  }

  /// Returns the error for a character that is neither a number nor a slash.
  [[nodiscard]] RuleProblem notANumber() const {
    if (at_ == text_.size()) return {at_, fmt::format("a slash is missing; {}", countsAdvice)};
    return {at_, fmt::format("{} is not a number of neighbours, 0 to {}; {}", shownCharacter(text_, at_),
                             maxCount(), countsAdvice)};
  }

  /// Reads digits with their letters up to the first different character.
  RuleProblem readCounts(Counts& counts) {
    unsigned seen = 0;
    while (at_ < text_.size() && isDigit(text_[at_])) {
      const int digit = text_[at_] - '0';
      if (digit > maxCount())
        return {at_, fmt::format("a cell has {} neighbours{}, not {}; {}", maxCount(),
                                 shape_ == NeighbourShape::vonNeumann  ? " with V"
                                 : shape_ == NeighbourShape::hexagonal ? " with H"
                                                                       : "",
                                 digit, countsAdvice)};
      if ((seen >> digit & 1U) != 0) return {at_, fmt::format("{} occurs twice; {}", digit, countsAdvice)};
      seen |= 1U << digit;
      ++at_;
      if (RuleProblem problem = letters(digit, counts); !problem.message.empty()) return problem;
    }
    return {};
  }

  RuleProblem letters(int digit, Counts& counts) {
    const int all = lettersOf(digit);
    const bool without = at_ < text_.size() && text_[at_] == '-';
    if (without) ++at_;
    int mask = 0;
    for (; at_ < text_.size() && text_[at_] >= 'a' && text_[at_] <= 'z'; ++at_) {
      const char c = text_[at_];
      const auto which = arrangementLetters.find(c);
      if (which == std::string_view::npos) break;
      if (shape_ != NeighbourShape::moore)
        return {at_,
                "letters describe the arrangement of eight neighbours; of four (V) or six (H) only the "
                "number counts"};
      if (digit == 0 || digit == 8)
        return {at_, fmt::format("{} neighbours have only one arrangement; remove the letter", digit)};
      if ((all >> which & 1) == 0)
        return {at_, fmt::format("there is no arrangement {} of {} neighbours; its letters are {}", c,
                                 digit, lettersThere(all))};
      if ((mask >> which & 1) != 0) return {at_, fmt::format("the letter {} occurs twice", c)};
      mask |= 1 << which;
    }
    counts[static_cast<std::size_t>(digit)] = without ? all & ~mask : mask == 0 ? all : mask;
    return {};
  }

  static std::string lettersThere(int letters) {
    std::string result;
    for (std::size_t i = 0; i < arrangementLetters.size(); ++i)
      if ((letters >> i & 1) != 0) result += arrangementLetters[i];
    return result;
  }

  /// Reads the numbers after the letters b and s, in either order; the slash between them is optional.
  RuleProblem lettered() {
    bool seen[2] = {};
    for (int part = 0; part < 2; ++part) {
      if (part == 1 && slash()) ++at_;
      const char wanted = part == 0 ? '?' : seen[0] ? 'S' : 'B';
      const char letter = at_ < text_.size() ? lowerLetter(text_[at_]) : '\0';
      if (part == 1 && letter != lowerLetter(wanted)) {
        if (at_ < text_.size() && text_[at_ - 1] != '/' && text_[at_ - 1] != '_') return notANumber();
        return {at_, fmt::format("{} {} is missing; {}", wanted == 'S' ? "an" : "a", wanted, countsAdvice)};
      }
      const std::size_t which = letter == 's' ? 1 : 0;
      seen[which] = true;
      ++at_;
      if (RuleProblem problem = readCounts(counts_[which]); !problem.message.empty()) return problem;
    }
    return {};
  }

  RuleProblem numbers() {
    if (RuleProblem problem = readCounts(counts_[1]); !problem.message.empty()) return problem;
    if (!slash()) return notANumber();
    ++at_;
    return readCounts(counts_[0]);
  }

  /// Reads the number of states: "/3", "/C3" or "/G3".
  RuleProblem states() {
    if (!slash()) return notANumber();
    ++at_;
    if (at_ < text_.size() && (lowerLetter(text_[at_]) == 'c' || lowerLetter(text_[at_]) == 'g')) ++at_;
    if (RuleProblem problem = takeRuleNumber(text_, at_, "the number of states", 2, 256, states_);
        !problem.message.empty())
      return problem;
    if (at_ < text_.size())
      return {at_, fmt::format("{} after the number of states", shownCharacter(text_, at_))};
    return {};
  }

  [[nodiscard]] bool holds(const Counts& counts, unsigned cells) const {
    if (shape_ == NeighbourShape::moore) {
      const Arrangement a = arrangementOf(cells);
      return (counts[static_cast<std::size_t>(a.count)] >> a.letter & 1) != 0;
    }
    return counts[static_cast<std::size_t>(std::popcount(cells & around(shape_)))] != 0;
  }

  [[nodiscard]] std::string part(const Counts& counts) const {
    std::string result;
    for (int n = 0; n <= maxCount(); ++n) {
      const int letters = counts[static_cast<std::size_t>(n)];
      if (shape_ == NeighbourShape::moore)
        result += arrangementText(n, letters);
      else if (letters != 0)
        result += static_cast<char>('0' + n);
    }
    return result;
  }

  [[nodiscard]] std::optional<LifeRule> plain() const {
    if (shape_ != NeighbourShape::moore || states_ != 2) return std::nullopt;
    int masks[2] = {};
    for (int which = 0; which < 2; ++which)
      for (int n = 0; n <= 8; ++n) {
        const int letters = counts_[which][static_cast<std::size_t>(n)];
        if (letters != 0 && letters != lettersOf(n)) return std::nullopt;
        if (letters != 0) masks[which] |= 1 << n;
      }
    return LifeRule{masks[0], masks[1]};
  }

  [[nodiscard]] CellRule made() const {
    if (const auto rule = plain()) return *rule;
    CellRule rule;
    rule.family = CellRule::Family::map;
    rule.states = states_;
    for (unsigned cells = 0; cells < 512; ++cells)
      if (holds(counts_[cells >> 4 & 1U], cells)) rule.map[cells / 32] |= 1U << (cells % 32);
    const char* suffix = shape_ == NeighbourShape::vonNeumann  ? "V"
                         : shape_ == NeighbourShape::hexagonal ? "H"
                                                               : "";
    rule.name = states_ == 2
                    ? fmt::format("B{}/S{}{}", part(counts_[0]), part(counts_[1]), suffix)
                    : fmt::format("{}/{}/{}{}", part(counts_[1]), part(counts_[0]), states_, suffix);
    return rule;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  NeighbourShape shape_ = NeighbourShape::moore;
  Counts counts_[2] = {};  ///< Allowed counts: [0] for birth, [1] for survival.
  int states_ = 2;
};

}  // namespace

RuleProblem parseCounts(std::string_view text, CellRule& rule) {
  return CountsReader(text).read(rule);
}

}  // namespace simreel::sim
