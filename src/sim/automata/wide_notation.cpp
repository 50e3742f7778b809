#include "base/text.hpp"
#include "sim/automata/notation.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr int maxWideRange = 500, maxCyclicRange = 10;  // Golly's

constexpr const char* wideAdvice =
    "Larger than Life is written as \"R5,C0,M1,S34..58,B34..45,NM\" (or \"5,34,45,34,58\")";
constexpr const char* cyclicAdvice = "a cyclic rule is written as \"R1/T3/C3/NM\"";

class FieldReader {
 public:
  FieldReader(std::string_view text, const char* advice) : text_(text), advice_(advice) {}

  /// A character, letters in either case; not found: the problem.
  void expect(char wanted) {
    if (!problem_.message.empty()) return;
    const char c = at_ < text_.size() ? text_[at_] : '\0';
    if (c != wanted && !(c >= 'a' && c <= 'z' && c - 'a' + 'A' == wanted)) {
      wrong(at_, fmt::format("'{}' is expected {}; {}", wanted, at_ < text_.size() ? "here" : "at the end",
                             advice_));
      return;
    }
    ++at_;
  }
  void number(const char* what, int min, int max, int& value) {
    if (!problem_.message.empty()) return;
    start_ = at_;
    problem_ = takeRuleNumber(text_, at_, what, min, max, value);
  }
  /// "34..58" or "34,45", each up to `max`.
  void limits(std::string_view between, const char* what, int max, int& low, int& high) {
    number(what, 0, max, low);
    const std::size_t first = start_;
    for (const char c : between) expect(c);
    number(what, 0, max, high);
    if (problem_.message.empty() && low > high)
      wrong(first, fmt::format("{} to {}: the first of these limits is the greater one", low, high));
  }
  NeighbourShape shape(std::string_view letters) {
    if (!problem_.message.empty()) return NeighbourShape::moore;
    const char c = at_ < text_.size() ? text_[at_] : '\0';
    const char upper = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    if (c == '\0' || letters.find(upper) == std::string_view::npos)
      wrong(at_, fmt::format("the neighbourhood is M (Moore){} (von Neumann){}",
                             letters.size() > 2 ? ", N" : " or N",
                             letters.size() > 2 ? " or C (circular)" : ""));
    ++at_;
    return upper == 'N'   ? NeighbourShape::vonNeumann
           : upper == 'C' ? NeighbourShape::circular
                          : NeighbourShape::moore;
  }
  void end() {
    if (problem_.message.empty() && at_ < text_.size())
      wrong(at_, fmt::format("{} after the end of the rule; {}", shownCharacter(text_, at_), advice_));
  }
  void wrong(std::size_t at, std::string message) {
    if (problem_.message.empty()) problem_ = {at, std::move(message)};
  }
  [[nodiscard]] const RuleProblem& problem() const { return problem_; }

 private:
  std::string_view text_;
  const char* advice_;
  std::size_t at_ = 0, start_ = 0;
  RuleProblem problem_;
};

int shapeCells(int range, NeighbourShape shape) {
  WideRule rule;
  rule.range = range;
  rule.shape = shape;
  int cells = 0;
  for (int dy = -range; dy <= range; ++dy) cells += 2 * rule.reach(dy) + 1;
  return cells;
}

}  // namespace

int WideRule::reach(int dy) const {
  const int row = dy < 0 ? -dy : dy;
  if (row > range) return -1;
  if (shape == NeighbourShape::vonNeumann) return range - row;
  if (shape != NeighbourShape::circular) return range;
  int dx = 0;
  while ((dx + 1) * (dx + 1) + row * row <= range * range + range) ++dx;
  return dx;
}

int WideRule::cells() const {
  return shapeCells(range, shape) - (middle ? 0 : 1);
}

RuleProblem parseWide(std::string_view text, CellRule& rule) {
  WideRule wide;
  int states = 0, middle = 1;
  FieldReader reader(text, wideAdvice);
  // The neighbourhood stands last, and says what the limits before it may be.
  const char last = text.empty() ? '\0' : text.back();
  const bool named = !text.empty() && !isDigit(text[0]);
  if (named) {
    wide.shape = last == 'N' || last == 'n'   ? NeighbourShape::vonNeumann
                 : last == 'C' || last == 'c' ? NeighbourShape::circular
                                              : NeighbourShape::moore;
    reader.expect('R');
    reader.number("the range", 1, maxWideRange, wide.range);
    reader.expect(',');
    reader.expect('C');
    reader.number("the number of states", 0, 256, states);
    reader.expect(',');
    reader.expect('M');
    reader.number("M", 0, 1, middle);
    reader.expect(',');
    wide.middle = middle == 1;
    const int most = reader.problem().message.empty() ? shapeCells(wide.range, wide.shape) : 0;
    reader.expect('S');
    reader.limits("..", "a limit of S", most, wide.surviveMin, wide.surviveMax);
    reader.expect(',');
    reader.expect('B');
    reader.limits("..", "a limit of B", most, wide.bornMin, wide.bornMax);
    reader.expect(',');
    reader.expect('N');
    wide.shape = reader.shape("MNC");
  } else {
    wide.middle = true;
    reader.number("the range", 1, maxWideRange, wide.range);
    reader.expect(',');
    const int most = reader.problem().message.empty() ? shapeCells(wide.range, wide.shape) : 0;
    reader.limits(",", "a limit of birth", most, wide.bornMin, wide.bornMax);
    reader.expect(',');
    reader.limits(",", "a limit of survival", most, wide.surviveMin, wide.surviveMax);
  }
  reader.end();
  if (!reader.problem().message.empty()) return reader.problem();
  rule = CellRule();
  rule.family = CellRule::Family::wide;
  rule.states = std::max(states, 2);
  rule.wide = wide;
  rule.name = fmt::format("R{},C{},M{},S{}..{},B{}..{},N{}", wide.range, states < 3 ? 0 : states,
                          wide.middle ? 1 : 0, wide.surviveMin, wide.surviveMax, wide.bornMin, wide.bornMax,
                          wide.shape == NeighbourShape::moore        ? 'M'
                          : wide.shape == NeighbourShape::vonNeumann ? 'N'
                                                                     : 'C');
  return {};
}

RuleProblem parseCyclic(std::string_view text, CellRule& rule) {
  CyclicRule cyclic;
  int states = 2;
  FieldReader reader(text, cyclicAdvice);
  const bool four = !text.empty() && (text.back() == 'N' || text.back() == 'n');
  reader.expect('R');
  reader.number("the range", 1, maxCyclicRange, cyclic.range);
  reader.expect('/');
  reader.expect('T');
  const int most = shapeCells(cyclic.range, four ? NeighbourShape::vonNeumann : NeighbourShape::moore) - 1;
  reader.number("the threshold", 1, most, cyclic.threshold);
  reader.expect('/');
  reader.expect('C');
  reader.number("the number of states", 2, 256, states);
  reader.expect('/');
  reader.expect('N');
  cyclic.shape = reader.shape("MN");
  reader.end();
  if (!reader.problem().message.empty()) return reader.problem();
  rule = CellRule();
  rule.family = CellRule::Family::cyclic;
  rule.states = states;
  rule.cyclic = cyclic;
  rule.name = fmt::format("R{}/T{}/C{}/N{}", cyclic.range, cyclic.threshold, states,
                          cyclic.shape == NeighbourShape::moore ? 'M' : 'N');
  return {};
}

}  // namespace simreel::sim
