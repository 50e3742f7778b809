#include "base/text.hpp"
#include "sim/life/cell_pattern.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

/// Parses the suffix of a bounded grid, such as "T30+5,20". For errors, calls `wrong`, which throws.
template <class Wrong>
class GridReader {
 public:
  GridReader(std::string_view text, std::size_t start, const Wrong& wrong)
      : text_(text), start_(start), at_(start), wrong_(wrong) {}

  std::size_t read(GridShape& shape, glm::ivec2& grid) {
    const char c = next();
    const char kind = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    if (kind != 'T' && kind != 'P' && kind != 'K' && kind != 'C' && kind != 'S')
      wrong_(at_,
             "a bounded grid is \":T257,130\" (torus), P (dead border), K (Klein bottle, "
             "\":K30*,20\"), C (cross-surface) or S (sphere, \":S30\")");
    ++at_;
    bool across = false, down = false;
    grid.x = side("the grid's width", across, shape.shift.x);
    grid.y = grid.x;
    if (kind != 'S' || next() == ',') {
      skipSpaces();
      if (next() != ',') wrong_(at_, "',' and the grid's height are expected here");
      ++at_;
      skipSpaces();
      grid.y = side("the grid's height", down, shape.shift.y);
    }
    if ((across || down) && kind != 'K') wrong_(start_, "'*' reverses edges of a Klein bottle only");
    if (kind == 'K' && across == down)
      wrong_(start_, "a Klein bottle has one pair of edges reversed, as in \":K30*,20\" or \":K30,20*\"");
    shape.border = kind == 'T'   ? GridBorder::torus
                   : kind == 'P' ? GridBorder::dead
                   : kind == 'C' ? GridBorder::crossSurface
                   : kind == 'S' ? GridBorder::sphere
                   : across      ? GridBorder::klein
                                 : GridBorder::kleinSideways;
    if (kind == 'K') shape.shift = {std::abs(shape.shift.x) % 2, std::abs(shape.shift.y) % 2};
    if (const std::string problem = shape.problem(grid); !problem.empty()) wrong_(start_, problem);
    return at_;
  }

 private:
  [[nodiscard]] char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void skipSpaces() {
    while (next() == ' ' || next() == '\t') ++at_;
  }

  int number(const char* what) {
    const std::size_t start = at_;
    if (!isDigit(next())) wrong_(at_, fmt::format("{} is missing here", what));
    long value = 0;
    for (; isDigit(next()); ++at_) value = std::min(value * 10 + (next() - '0'), 10L * maxLifeSide);
    if (value > maxLifeSide) wrong_(start, fmt::format("{} is above {}, the maximum", what, maxLifeSide));
    return static_cast<int>(value);
  }

  /// Reads one side of the grid: the number of cells, '*' if its edges are reversed, and a shift.
  int side(const char* what, bool& reversed, int& shift) {
    const std::size_t start = at_;
    const int cells = number(what);
    if (cells == 0)
      wrong_(start, "a side of 0 means an endless grid, which is not supported; give both sides");
    if (next() == '*') {
      reversed = true;
      ++at_;
    }
    if (next() == '+' || next() == '-') {
      const bool less = next() == '-';
      ++at_;
      shift = number("the shift") % cells * (less ? -1 : 1);
    }
    return cells;
  }

  std::string_view text_;
  std::size_t start_, at_;
  const Wrong& wrong_;
};

}  // namespace

std::size_t PatternText::takeGrid(std::size_t start) {
  const auto fails = [this](std::size_t at, const std::string& message) { wrong(at, message); };
  GridShape shape;
  const std::size_t end = GridReader(text_, start, fails).read(shape, pattern_.grid);
  pattern_.shape = shape;
  return end;
}

}  // namespace simreel::sim
