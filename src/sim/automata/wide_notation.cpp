#include "base/text.hpp"
#include "sim/automata/notation.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr int maxWideRange = 500, maxTriangleRange = 250, maxGaussianRange = 50,
              maxCyclicRange = 10;  // Golly's

/// What the kernel that goes through a list can do in one go (glsl/automata/places.comp), and what is
/// written into a kernel's text.
constexpr std::size_t maxPlaces = 60000, maxRanges = 200;

constexpr const char* wideAdvice =
    "Larger than Life is written as \"R5,C0,M1,S34..58,B34..45,NM\" (or \"5,34,45,34,58\", or "
    "\"R2,C0,S2-3,8,B3,NN\")";
constexpr const char* cyclicAdvice = "a cyclic rule is written as \"R1/T3/C3/NM\"";

char upperLetter(char c) {
  return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
}

int hexValue(char c) {
  const char upper = upperLetter(c);
  return isDigit(upper) ? upper - '0' : upper >= 'A' && upper <= 'F' ? upper - 'A' + 10 : -1;
}

class FieldReader {
 public:
  FieldReader(std::string_view text, const char* advice) : text_(text), advice_(advice) {}

  [[nodiscard]] bool good() const { return problem_.message.empty(); }
  /// The character here, a capital; 0 at the end.
  [[nodiscard]] char here() const { return at_ < text_.size() ? upperLetter(text_[at_]) : '\0'; }
  [[nodiscard]] std::size_t at() const { return at_; }
  void moveTo(std::size_t at) { at_ = at; }

  /// A character, letters in either case; not found: the problem.
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
  /// "34..58" or "34,45", each up to `max`.
  void limits(std::string_view between, const char* what, int max, std::vector<CountRange>& counts) {
    counts.assign(1, {0, 0});
    auto& [low, high] = counts[0];
    number(what, 0, max, low);
    const std::size_t first = start_;
    for (const char c : between) expect(c);
    number(what, 0, max, high);
    if (good() && low > high)
      wrong(first, fmt::format("{} to {}: the first of these limits is the greater one", low, high));
  }
  /// "2-3,8", or nothing; a comma that no number follows is left.
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
              fmt::format("{} to {}: the first of these limits is the greater one", range.low, range.high));
      counts.push_back(range);
      if (here() == ',' && at_ + 1 < text_.size() && isDigit(text_[at_ + 1])) ++at_;
    }
    join(counts);
    if (counts.size() > maxRanges)
      wrong(start, fmt::format("{} ranges of counts; there are {} at most", counts.size(), maxRanges));
  }
  /// Digits of base 16; behind them, here() is none.
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
  /// Sorted, and those that touch as one.
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

/// The neighbourhood behind the N that ends a rule, for a rule of so many states.
class NeighbourhoodReader {
 public:
  NeighbourhoodReader(FieldReader& reader, WideRule& rule, int states)
      : reader_(reader), rule_(rule), states_(states) {}

  void read() {
    const char letter = reader_.here();
    const std::size_t at = reader_.at();
    reader_.moveTo(at + 1);
    switch (letter) {
      case 'M':
        return;
      case 'N':
        rule_.shape = NeighbourShape::vonNeumann;
        return;
      case 'C':
        rule_.shape = NeighbourShape::circular;
        return;
      case '2':
        rule_.shape = NeighbourShape::euclidean;
        return;
      case '+':
        rule_.shape = NeighbourShape::cross;
        return;
      case 'H':
        rule_.shape = NeighbourShape::hexagonal;
        return;
      case '@':
        custom(at);
        break;
      case 'W':
        weighted(at);
        break;
      case 'X':
      case '*':
      case '#':
      case 'B':
      case 'D':
      case 'A':
      case '3':
      case 'G':
      case 'L':
        named(letter, at);
        break;
      default:
        reader_.wrong(
            at,
            "the neighbourhood is M (Moore), N (von Neumann), C (circular), 2 (Euclidean), + (cross), X "
            "(saltire), * (star), # (hash), B or D (checkerboards), H (hexagonal), A (asterisk), 3 "
            "(tripod), "
            "L (triangular), G (Gaussian), @ (custom) or W (weighted)");
        return;
    }
    rule_.shape = NeighbourShape::places;
    if (rule_.places.size() > maxPlaces)
      reader_.wrong(at, fmt::format("of this range this neighbourhood has {} cells; there may be {}",
                                    rule_.places.size(), maxPlaces));
  }

 private:
  void named(char letter, std::size_t at) {
    const int most = letter == 'L' ? maxTriangleRange : letter == 'G' ? maxGaussianRange : maxWideRange;
    if (rule_.range > most) {
      reader_.wrong(at, fmt::format("the range of this neighbourhood is {} at most", most));
      return;
    }
    rule_.places = placesOfShape(letter, rule_.range);
    rule_.flips = letter == 'L';
    if (letter == 'L') rule_.range *= 2;
  }

  /// A bit a cell, row by row without the middle.
  void custom(std::size_t at) {
    const std::vector<int> digits = reader_.hexDigits();
    const int side = 2 * rule_.range + 1, cells = side * side;
    if (digits.size() * 4 != static_cast<std::size_t>(cells) - 1) {
      reader_.wrong(
          at + 1, fmt::format("{} hexadecimal digits where {} tell which of the {} cells of range {} count",
                              digits.size(), (cells - 1) / 4, cells - 1, rule_.range));
      return;
    }
    for (int i = 0; i < cells; ++i) {
      const int bit = i < cells / 2 ? i : i - 1;
      if (i == cells / 2 || (digits[static_cast<std::size_t>(bit / 4)] >> (3 - bit % 4) & 1) != 0)
        rule_.places.push_back({i % side - rule_.range, i / side - rule_.range, 1});
    }
    suffix();
  }

  /// One or two digits a cell, row by row, the first bit for minus.
  void weighted(std::size_t at) {
    const std::vector<int> digits = reader_.hexDigits();
    const int side = 2 * rule_.range + 1, cells = side * side;
    const bool two = digits.size() == 2 * static_cast<std::size_t>(cells);
    if (!two && digits.size() != static_cast<std::size_t>(cells)) {
      reader_.wrong(
          at + 1,
          fmt::format("{} hexadecimal digits where {} or {} are the weights of the cells of range {}",
                      digits.size(), cells, 2 * cells, rule_.range));
      return;
    }
    for (int i = 0; i < cells; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const int value = two ? digits[2 * k] * 16 + digits[2 * k + 1] : digits[k], sign = two ? 128 : 8;
      const int weight = value >= sign ? sign - value : value;
      if (weight != 0) rule_.places.push_back({i % side - rule_.range, i / side - rule_.range, weight});
    }
    rule_.middle = true;
    if (reader_.here() == ',') {
      const std::size_t first = reader_.at() + 1;
      reader_.moveTo(first);
      rule_.stateWeights = reader_.hexDigits();
      if (rule_.stateWeights.size() != static_cast<std::size_t>(states_))
        reader_.wrong(first, fmt::format("{} weights of states; the rule has {} states",
                                         rule_.stateWeights.size(), states_));
    }
    suffix();
  }

  /// H: to be drawn as hexagons; L: of triangles.
  void suffix() {
    if (reader_.here() != 'H' && reader_.here() != 'L') return;
    rule_.flips = reader_.here() == 'L';
    reader_.moveTo(reader_.at() + 1);
  }

  FieldReader& reader_;
  WideRule& rule_;
  int states_;
};

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

/// "R5,C0,M1,S34..58,B34..45,NM" and "R2,C0,S2-3,8,B3,NN".
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
  /// The neighbourhood stands last, and says what the limits before it may be.
  void neighbourhood() {
    const std::string upper = upperText(text_);
    const std::size_t at = upper.find(",N");
    if (at == std::string::npos) return;
    FieldReader after(text_, wideAdvice);
    after.moveTo(at + 2);
    NeighbourhoodReader(after, wide_, std::max(states_, 2)).read();
    // What stands before it is told first.
    problemAfter_ = after.problem();
    hood_ = upper.substr(at + 2, after.at() - at - 2);
  }
  /// Of no neighbourhood nothing is known: its mistake is told once all before it is read.
  [[nodiscard]] int most() const { return problemAfter_.message.empty() ? wide_.most() : 1'000'000; }
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
    reader_.limits("..", "a limit of S", most(), wide_.survive);
    reader_.expect(',');
    reader_.expect('B');
    reader_.limits("..", "a limit of B", most(), wide_.born);
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
    const bool own = !hood_.empty() && hood_[0] == 'W';  // weights count the middle as they say
    reader_.expect('S');
    reader_.list("a count of S", most() - (own ? 0 : 1), wide_.survive);
    reader_.expect(',');
    reader_.expect('B');
    reader_.list("a count of B", most() - (own ? 0 : 1), wide_.born);
    tellAfter();
    name_ = fmt::format("R{},C{},S{},B{}{}{}", range_, states_ < 3 ? 0 : states_, listText(wide_.survive),
                        listText(wide_.born), hood_.empty() || hood_ == "M" ? "" : ",N",
                        hood_ == "M" ? "" : hood_);
  }

  std::string_view text_;
  FieldReader reader_;
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
      const int most = range * range + (shape == NeighbourShape::circular ? range : 0);
      across = 0;
      while ((across + 1) * (across + 1) + row * row <= most) ++across;
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

int WideRule::most() const {
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
  FieldReader reader(text, wideAdvice);
  wide.middle = true;
  reader.number("the range", 1, maxWideRange, wide.range);
  reader.expect(',');
  reader.limits(",", "a limit of birth", wide.most(), wide.born);
  reader.expect(',');
  reader.limits(",", "a limit of survival", wide.most(), wide.survive);
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
  FieldReader reader(text, cyclicAdvice);
  const bool four = !text.empty() && (text.back() == 'N' || text.back() == 'n');
  reader.expect('R');
  reader.number("the range", 1, maxCyclicRange, cyclic.range);
  reader.expect('/');
  reader.expect('T');
  WideRule around;
  around.range = cyclic.range;
  if (four) around.shape = NeighbourShape::vonNeumann;
  reader.number("the threshold", 1, around.most() - 1, cyclic.threshold);
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
