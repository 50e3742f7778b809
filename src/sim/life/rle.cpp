#include "sim/life/rle.hpp"

#include "base/text.hpp"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdlib>
#include <iterator>

#include <fmt/format.h>
#include <glm/common.hpp>

namespace simreel::sim {

namespace {

constexpr std::size_t lineLength = 70;

bool isBlank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}
class RleReader : public PatternText {
 public:
  using PatternText::PatternText;

  CellPattern read() {
    comments();
    headed_ = at_ < text_.size() && text_[at_] == 'x';
    if (headed_) header();
    placeInGrid();
    while (true) {
      skipBlanks();
      if (at_ == text_.size()) {
        if (!headed_ && empty_) wrong(0, "no pattern: neither a header nor a cell");
        if (headed_)
          pattern_.remark = fmt::format("{}: the pattern ends without '!'; the file may be cut off", name_);
        return std::move(pattern_);
      }
      if (text_[at_] == '#' && atLineStart())
        skipLine();
      else if (!item())
        return std::move(pattern_);
    }
  }

 private:
  [[nodiscard]] bool atLineStart() const { return at_ == 0 || text_[at_ - 1] == '\n'; }
  void skipLine() {
    const auto end = text_.find('\n', at_);
    at_ = end == std::string_view::npos ? text_.size() : end + 1;
  }
  void skipBlanks() {
    while (at_ < text_.size() && isBlank(text_[at_])) ++at_;
  }
  void skipSpaces() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  /// Reads the comments at the beginning. Golly stores the pattern's position in them ("#CXRLE Pos=-3,4
  /// Gen=0"), XLife the rule ("#r 23/3").
  void comments() {
    for (skipBlanks(); at_ < text_.size() && text_[at_] == '#'; skipBlanks()) {
      const std::size_t start = at_;
      skipLine();
      std::string_view line = text_.substr(start, at_ - start);
      while (!line.empty() && isBlank(line.back())) line.remove_suffix(1);
      if (line.starts_with("#CXRLE")) position(line, start);
      const std::size_t rule = std::min(line.find_first_not_of(" \t", 2), line.size());
      if (line.starts_with("#r ") && !pattern_.rule && rule < line.size())
        takeRuleText(start + rule, line.substr(rule, line.find_first_of(" \t", rule) - rule));
    }
  }

  /// Reads the position of the top left corner, relative to the centre of the grid.
  void position(std::string_view line, std::size_t start) {
    constexpr std::string_view key = "Pos=";
    const std::size_t at = line.find(key);
    if (at == std::string_view::npos) return;
    std::string_view rest = line.substr(at + key.size());
    const auto x = takeInteger(rest);
    const bool both = rest.starts_with(',');
    if (both) rest.remove_prefix(1);
    const auto y = takeInteger(rest);
    if (!x || !both || !y || std::max(std::abs(*x), std::abs(*y)) > 2 * maxLifeSide)
      wrong(start + at, "a place is expected here, as in \"Pos=-16,4\"");
    position_ = {*x, *y};
  }
  void placeInGrid() {
    if (pattern_.shape && position_) pattern_.corner = *position_ + pattern_.grid / 2;
  }

  /// Reads digits as a number up to `max`. `what` is the number's name in messages.
  int number(const char* what, int max) {
    const std::size_t start = at_;
    if (at_ == text_.size() || !isDigit(text_[at_])) wrong(at_, fmt::format("{} is missing here", what));
    long value = 0;
    for (; at_ < text_.size() && isDigit(text_[at_]); ++at_)
      value = std::min(value * 10 + (text_[at_] - '0'), 10L * maxLifeSide);
    if (value > max) wrong(start, fmt::format("{} is above {}, the maximum", what, max));
    return static_cast<int>(value);
  }

  void expect(char c) {
    skipSpaces();
    if (at_ == text_.size() || text_[at_] != c)
      wrong(at_, fmt::format("'{}' is expected here: the header is \"x = 3, y = 3, rule = B3/S23\"", c));
    ++at_;
    skipSpaces();
  }

  void header() {
    expect('x');
    expect('=');
    pattern_.size.x = number("the width", maxLifeSide);
    expect(',');
    expect('y');
    expect('=');
    pattern_.size.y = number("the height", maxLifeSide);
    skipSpaces();
    if (at_ < text_.size() && text_[at_] == ',') {
      ++at_;
      skipSpaces();
      if (text_.substr(at_, 4) != "rule") wrong(at_, "only \"rule = ...\" may follow the height");
      at_ += 4;
      expect('=');
      rule();
    }
    skipSpaces();
    if (at_ < text_.size() && text_[at_] == '\r') ++at_;
    if (at_ < text_.size() && text_[at_] != '\n')
      wrong(at_, fmt::format("{} after the header; the cells begin on a new line", shown(text_[at_])));
  }

  void rule() {
    const std::size_t start = at_;
    while (at_ < text_.size() && !isBlank(text_[at_]) && text_[at_] != ':') ++at_;
    const std::string_view name = text_.substr(start, at_ - start);
    takeRuleText(start, name);
    if (at_ < text_.size() && text_[at_] == ':') at_ = takeGrid(at_ + 1);
  }

  /// Reads one count and its symbol. Returns false at the final '!'.
  bool item() {
    const std::size_t start = at_;
    int count = 1;
    if (isDigit(text_[at_])) {
      count = number("the count", maxLifeSide);
      if (count == 0) wrong(start, "a count of 0");
      skipBlanks();
      if (at_ == text_.size()) wrong(at_, "the file ends after a count; it may be cut off");
      if (isDigit(text_[at_])) wrong(at_, "a second count; b, o or $ is expected");
    }
    const char c = text_[at_];
    empty_ = false;
    if (c == '!') {
      if (at_ != start) wrong(at_, "a count before '!'");
      return false;
    }
    if (c == '$') {
      place_.y = std::min(place_.y + count, 2 * maxLifeSide);
      place_.x = 0;
    } else if (c == 'b' || c == '.') {
      place_.x = std::min(place_.x + count, 2 * maxLifeSide);
    } else if (c == 'o') {
      living(start, count, 1);
    } else if (c >= 'A' && c <= 'X') {
      living(start, count, c - 'A' + 1);
    } else if (c >= 'p' && c <= 'y') {
      const char second = at_ + 1 < text_.size() ? text_[at_ + 1] : '\0';
      const int state = (c - 'p' + 1) * 24 + second - 'A' + 1;
      if (second < 'A' || second > 'X' || state > 255)
        wrong(at_,
              fmt::format("{} begins a state above 24, as in pA (25) to yO (255); no such letter follows",
                          shown(c)));
      living(start, count, state);
      ++at_;
    } else {
      wrong(at_, fmt::format("{} where b, o, $ or ! is expected", shown(c)));
    }
    ++at_;
    return true;
  }

  void living(std::size_t start, int count, int state) {
    const glm::ivec2 end(place_.x + count, place_.y + 1);
    if (headed_ && (end.x > pattern_.size.x || end.y > pattern_.size.y))
      wrong(start, fmt::format("living cells {} to {} of row {} lie outside the header's {} x {}", place_.x,
                               end.x - 1, place_.y, pattern_.size.x, pattern_.size.y));
    if (end.x > maxLifeSide || end.y > maxLifeSide)
      wrong(start, fmt::format("a living cell at [{}, {}], beyond {}, the farthest that is allowed",
                               end.x - 1, place_.y, maxLifeSide));
    if (!headed_) pattern_.size = glm::max(pattern_.size, end);
    add(place_.x, place_.y, count, state, start);
    place_.x = end.x;
  }

  bool headed_ = false;  ///< true if a header has given the size
  bool empty_ = true;
  glm::ivec2 place_{0, 0};
  std::optional<glm::ivec2> position_;  ///< position relative to the centre of the grid
};

/// Appends run-length items and breaks lines between them.
class RleWriter {
 public:
  explicit RleWriter(std::string& out) : out_(out) {}
  void add(long count, std::string_view what) {
    if (count == 0) return;
    char item[24];
    char* end = item;
    if (count > 1) end = std::to_chars(item, std::end(item) - 2, count).ptr;
    end = std::copy(what.begin(), what.end(), end);
    const auto length = static_cast<std::size_t>(end - item);
    if (length_ + length > lineLength) {
      out_ += '\n';
      length_ = 0;
    }
    out_.append(item, length);
    length_ += length;
  }

 private:
  std::string& out_;
  std::size_t length_ = 0;
};

/// Returns the first column from `x` on whose cell's state equals `alive`, or the width.
int nextColumn(const CellRows& cells, int x, int y, bool alive) {
  const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(CellRows::rowWords(cells.size.x));
  while (x < cells.size.x) {
    const std::uint32_t word = cells.words[row + static_cast<std::size_t>(x) / 32];
    const std::uint32_t wanted = (alive ? word : ~word) >> (x % 32);
    if (wanted != 0) return std::min(x + std::countr_zero(wanted), cells.size.x);
    x += 32 - x % 32;
  }
  return cells.size.x;
}

}  // namespace

CellPattern parseRle(std::string_view text, const std::string& name) {
  return RleReader(text, name).read();
}

namespace {

std::string rleHead(glm::ivec2 size, const CellRule& rule, std::string_view suffix,
                    std::string_view comment) {
  std::string out;
  while (!comment.empty()) {
    const auto end = comment.find('\n');
    out += fmt::format("#C {}\n", comment.substr(0, end));
    comment.remove_prefix(end == std::string_view::npos ? comment.size() : end + 1);
  }
  out += fmt::format("x = {}, y = {}, rule = {}{}\n", size.x, size.y, rule.text(), suffix);
  return out;
}

}  // namespace

std::string writeStatesRle(const StateRows& cells, const CellRule& rule, std::string_view suffix,
                           std::string_view comment) {
  std::string out = rleHead(cells.size, rule, suffix, comment);
  RleWriter writer(out);
  long rowEnds = 0;
  for (int y = 0; y < cells.size.y; ++y, ++rowEnds) {
    int written = 0;
    for (int x = 0; x < cells.size.x;) {
      const int state = cells.state(x, y);
      int end = x + 1;
      while (end < cells.size.x && cells.state(end, y) == state) ++end;
      if (state != 0) {
        writer.add(rowEnds, "$");
        rowEnds = 0;
        writer.add(x - written, ".");
        const char letter[3] = {static_cast<char>('o' + (state - 1) / 24),
                                static_cast<char>('A' + (state - 1) % 24), '\0'};
        writer.add(end - x, state > 24 ? letter : letter + 1);
        written = end;
      }
      x = end;
    }
  }
  writer.add(1, "!");
  out += '\n';
  return out;
}

std::string writeRle(const CellRows& cells, const CellRule& rule, std::string_view suffix,
                     std::string_view comment) {
  std::string out = rleHead(cells.size, rule, suffix, comment);
  RleWriter writer(out);
  long rowEnds = 0;
  for (int y = 0; y < cells.size.y; ++y, ++rowEnds) {
    int written = 0;
    for (int x = nextColumn(cells, 0, y, true); x < cells.size.x;) {
      const int end = nextColumn(cells, x, y, false);
      writer.add(rowEnds, "$");
      rowEnds = 0;
      writer.add(x - written, "b");
      writer.add(end - x, "o");
      written = end;
      x = nextColumn(cells, end, y, true);
    }
  }
  writer.add(1, "!");
  out += '\n';
  return out;
}

}  // namespace simreel::sim
