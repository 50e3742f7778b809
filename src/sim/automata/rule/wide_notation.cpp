#include "sim/automata/rule/notation_reader.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr int maxWideRange = 500, maxCyclicRange = 10;  // the same limits as in Golly

constexpr const char* wideAdvice =
    "Larger than Life is written as \"R5,C0,M1,S34..58,B34..45,NM\" (or \"5,34,45,34,58\", or "
    "\"R2,C0,S2-3,8,B3,NN\")";
constexpr const char* cyclicAdvice = "a cyclic rule is written as \"R1/T3/C3/NM\"";

std::string upperText(std::string_view text) {
  std::string upper(text);
  std::ranges::transform(upper, upper.begin(), upperLetter);
  return upper;
}

std::string listText(const std::vector<CountRange>& counts) {
  std::string text;
  for (const CountRange& range : counts)
    text += fmt::format("{}{}{}", text.empty() ? "" : ",", range.low,
                        range.high > range.low ? fmt::format("-{}", range.high) : "");
  return text;
}

/// Reads "R5,C0,M1,S34..58,B34..45,NM" and "R2,C0,S2-3,8,B3,NN".
class WideReader {
 public:
  explicit WideReader(std::string_view text) : text_(text), reader_(text, wideAdvice) {}

  RuleProblem read(CellRule& rule) {
    reader_.expect('R');
    reader_.number("the range", 1, maxWideRange, wide_.range);
    reader_.expect(',');
    reader_.expect('C');
    reader_.number("the number of states", 0, 256, states_);
    reader_.expect(',');
    range_ = wide_.range;
    if (reader_.good()) neighbourhood();
    if (reader_.here() == 'M')
      limits();
    else
      lists();
    if (reader_.good() && !hood_.empty()) {
      reader_.expect(',');
      reader_.expect('N');
      reader_.moveTo(reader_.at() + hood_.size());
    }
    reader_.end();
    if (!reader_.good()) return reader_.problem();
    rule = CellRule();
    rule.family = CellRule::Family::wide;
    rule.states = std::max(states_, 2);
    rule.wide = wide_;
    rule.name = name_;
    return {};
  }

 private:
  /// Reads the neighbourhood first. It is at the end of the text, but the maximum of the counts (for
  /// survival and birth) before it depends on it.
  void neighbourhood() {
    const std::string upper = upperText(text_);
    const std::size_t at = upper.find(",N");
    if (at == std::string::npos) return;
    NotationReader after(text_, wideAdvice);
    after.moveTo(at + 2);
    readNeighbourhood(after, wide_, std::max(states_, 2));
    // An error in the neighbourhood is reported only if the text before it is valid.
    problemAfter_ = after.problem();
    hood_ = upper.substr(at + 2, after.at() - at - 2);
  }
  /// Returns the maximum of a count. It is very large if the neighbourhood has an error, which is reported
  /// after the errors of the counts.
  [[nodiscard]] int maximum() const { return problemAfter_.message.empty() ? wide_.maximum() : 1'000'000; }
  void tellAfter() {
    if (!problemAfter_.message.empty()) reader_.wrong(problemAfter_.at, problemAfter_.message);
  }

  void limits() {
    int middle = 0;
    reader_.expect('M');
    reader_.number("M", 0, 1, middle);
    reader_.expect(',');
    if (wide_.shape != NeighbourShape::places || hood_[0] != 'W') wide_.middle = middle == 1;
    reader_.expect('S');
    reader_.limits("..", "a limit of S", maximum(), wide_.survive);
    reader_.expect(',');
    reader_.expect('B');
    reader_.limits("..", "a limit of B", maximum(), wide_.born);
    tellAfter();
    if (hood_.empty()) {
      reader_.expect(',');
      reader_.expect('N');
    }
    name_ = fmt::format("R{},C{},M{},S{}..{},B{}..{},N{}", range_, states_ < 3 ? 0 : states_, middle,
                        wide_.survive[0].low, wide_.survive[0].high, wide_.born[0].low, wide_.born[0].high,
                        hood_);
  }

  void lists() {
    const bool own = !hood_.empty() && hood_[0] == 'W';  // true if the neighbourhood gives explicit
                                                         // weights, which include the centre
    reader_.expect('S');
    reader_.list("a count of S", maximum() - (own ? 0 : 1), wide_.survive);
    reader_.expect(',');
    reader_.expect('B');
    reader_.list("a count of B", maximum() - (own ? 0 : 1), wide_.born);
    tellAfter();
    name_ = fmt::format("R{},C{},S{},B{}{}{}", range_, states_ < 3 ? 0 : states_, listText(wide_.survive),
                        listText(wide_.born), hood_.empty() || hood_ == "M" ? "" : ",N",
                        hood_ == "M" ? "" : hood_);
  }

  std::string_view text_;
  NotationReader reader_;
  WideRule wide_;
  int states_ = 0, range_ = 1;
  std::string hood_, name_;
  RuleProblem problemAfter_;
};

}  // namespace

WideRule::Span WideRule::span(int dy) const {
  const int row = dy < 0 ? -dy : dy;
  if (row > range) return {1, 0};
  int across = range;
  switch (shape) {
    case NeighbourShape::vonNeumann:
      across = range - row;
      break;
    case NeighbourShape::circular:
    case NeighbourShape::euclidean: {
      const int maximum = range * range + (shape == NeighbourShape::circular ? range : 0);
      across = 0;
      while ((across + 1) * (across + 1) + row * row <= maximum) ++across;
      break;
    }
    case NeighbourShape::cross:
      across = row == 0 ? range : 0;
      break;
    case NeighbourShape::hexagonal:
      return {std::max(-range, dy - range), std::min(range, dy + range)};
    default:
      break;
  }
  return {-across, across};
}

int WideRule::maximum() const {
  int count = 0;
  if (shape == NeighbourShape::places) {
    for (const NeighbourPlace& place : places) count += std::max(place.weight, 0);
    return stateWeights.empty() ? count : count * *std::ranges::max_element(stateWeights);
  }
  for (int dy = -range; dy <= range; ++dy) count += span(dy).last - span(dy).first + 1;
  return count;
}

RuleProblem parseWide(std::string_view text, CellRule& rule) {
  if (!text.empty() && !isDigit(text[0])) return WideReader(text).read(rule);
  WideRule wide;
  NotationReader reader(text, wideAdvice);
  wide.middle = true;
  reader.number("the range", 1, maxWideRange, wide.range);
  reader.expect(',');
  reader.limits(",", "a limit of birth", wide.maximum(), wide.born);
  reader.expect(',');
  reader.limits(",", "a limit of survival", wide.maximum(), wide.survive);
  reader.end();
  if (!reader.good()) return reader.problem();
  rule = CellRule();
  rule.family = CellRule::Family::wide;
  rule.wide = wide;
  rule.name = fmt::format("R{},C0,M1,S{}..{},B{}..{},NM", wide.range, wide.survive[0].low,
                          wide.survive[0].high, wide.born[0].low, wide.born[0].high);
  return {};
}

RuleProblem parseCyclic(std::string_view text, CellRule& rule) {
  CyclicRule cyclic;
  int states = 2;
  NotationReader reader(text, cyclicAdvice);
  const bool four = !text.empty() && (text.back() == 'N' || text.back() == 'n');
  reader.expect('R');
  reader.number("the range", 1, maxCyclicRange, cyclic.range);
  reader.expect('/');
  reader.expect('T');
  WideRule around;
  around.range = cyclic.range;
  if (four) around.shape = NeighbourShape::vonNeumann;
  reader.number("the threshold", 1, around.maximum() - 1, cyclic.threshold);
  reader.expect('/');
  reader.expect('C');
  reader.number("the number of states", 2, 256, states);
  reader.expect('/');
  reader.expect('N');
  cyclic.shape = reader.cyclicShape();
  reader.end();
  if (!reader.good()) return reader.problem();
  rule = CellRule();
  rule.family = CellRule::Family::cyclic;
  rule.states = states;
  rule.cyclic = cyclic;
  rule.name = fmt::format("R{}/T{}/C{}/N{}", cyclic.range, cyclic.threshold, states,
                          cyclic.shape == NeighbourShape::moore ? 'M' : 'N');
  return {};
}

}  // namespace simreel::sim
