#include "sim/life/macrocell.hpp"

#include "base/text.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr std::int64_t manyCells = std::int64_t{1} << 60;
constexpr int maxLevel = 60;

/// Quadtree node: a square with sides of 2^level cells. A leaf holds either 64 bits (8 x 8 cells, row by
/// row, lowest bit first) or four states.
struct Node {
  int level = 0;
  bool leaf = false;
  std::int64_t cells = 0;  ///< number of live cells, at most manyCells; a node without live cells is never
                           ///< traversed, however often it is referenced
  std::uint64_t bits = 0;
  std::array<int, 4> children{};  ///< node indices or states of the quadrants NW, NE, SW, SE
};

class MacrocellReader : public PatternText {
 public:
  using PatternText::PatternText;

  CellPattern read(std::size_t maxCells) {
    nodes_.emplace_back();  // node 0 is an empty square
    while (at_ < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      std::string_view line = text_.substr(at_, end - at_);
      while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.remove_suffix(1);
      readLine(line);
      at_ = end + 1;
    }
    if (nodes_.size() < 2) wrong(text_.size(), "no squares; the file may be cut off");
    for (std::size_t i = 1; i + 1 < nodes_.size(); ++i)
      if (nodes_[i].level > nodes_.back().level)
        wrong(text_.size(), "the last square is not the largest one; the file may be cut off");
    if (static_cast<std::uint64_t>(nodes_.back().cells) > maxCells)
      wrong(0, fmt::format("more than {} living cells", maxCells));
    collect(static_cast<int>(nodes_.size()) - 1, 0, 0);
    return fitted();
  }

 private:
  void readLine(std::string_view line) {
    if (line.empty() || line[0] == '[') return;
    if (line[0] == '#') {
      if (line.starts_with("#R")) rule(line);
      return;
    }
    if (line[0] == '.' || line[0] == '*' || line[0] == '$')
      raster(line);
    else
      square(line);
  }

  void rule(std::string_view line) {
    const std::size_t start = line.find_first_not_of(" \t", 2);
    if (start == std::string_view::npos) return;
    std::string_view text = line.substr(start);
    const std::size_t colon = text.find(':');
    takeRuleText(at_ + start, text.substr(0, colon));
    if (colon != std::string_view::npos) takeGrid(at_ + start + colon + 1);
  }

  void raster(std::string_view line) {
    Node node;
    node.level = 3;
    node.leaf = true;
    int x = 0, y = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (line[i] == '$') {
        x = 0;
        ++y;
        continue;
      }
      if (line[i] != '.' && line[i] != '*')
        wrong(at_ + i,
              fmt::format("{} in a square of 8 x 8 cells: '.', '*' or '$' is expected", shown(line[i])));
      if (x > 7 || y > 7) wrong(at_ + i, "a cell beyond a square of 8 x 8");
      if (line[i] == '*') node.bits |= std::uint64_t{1} << (y * 8 + x);
      ++x;
    }
    node.cells = std::popcount(node.bits);
    nodes_.push_back(node);
  }

  void square(std::string_view line) {
    std::array<long, 5> values{};
    std::size_t i = 0;
    for (std::size_t n = 0; n < values.size(); ++n) {
      while (i < line.size() && line[i] == ' ') ++i;
      if (i == line.size() || !isDigit(line[i]))
        wrong(at_ + i, "a square is five numbers: the logarithm of its size and its four quarters");
      const std::size_t start = i;
      for (; i < line.size() && isDigit(line[i]); ++i)
        values[n] = std::min(values[n] * 10 + (line[i] - '0'), 1L << 40);
      check(n, values, start);
    }
    if (i < line.size()) wrong(at_ + i, fmt::format("{} after the five numbers", shown(line[i])));
    Node node;
    node.level = static_cast<int>(values[0]);
    node.leaf = node.level == 1;
    for (std::size_t n = 0; n < 4; ++n) {
      const int child = node.children[n] = static_cast<int>(values[n + 1]);
      const std::int64_t more =
          node.leaf ? (child != 0 ? 1 : 0) : nodes_[static_cast<std::size_t>(child)].cells;
      node.cells = std::min(node.cells + more, manyCells);
    }
    nodes_.push_back(node);
  }

  void check(std::size_t n, const std::array<long, 5>& values, std::size_t start) const {
    const long value = values[n];
    if (n == 0) {
      if (value < 1 || value > maxLevel)
        wrong(at_ + start, fmt::format("a square's size is 2 to the power of 1 to {}", maxLevel));
    } else if (values[0] == 1) {
      if (value > 255) wrong(at_ + start, "states go from 0 to 255");
    } else if (value >= static_cast<long>(nodes_.size())) {
      wrong(at_ + start, fmt::format("square {} does not come before this one", value));
    } else if (value > 0 && nodes_[static_cast<std::size_t>(value)].level != values[0] - 1) {
      wrong(at_ + start, fmt::format("square {} is not half as large", value));
    }
  }

  void cell(std::int64_t x, std::int64_t y, int state) {
    if (pattern_.runs.empty()) origin_ = {x, y};
    const std::int64_t dx = x - origin_.first, dy = y - origin_.second;
    if (std::max(std::abs(dx), std::abs(dy)) > maxLifeSide)
      wrong(0, fmt::format("living cells are more than {} apart, the maximum", maxLifeSide));
    add(static_cast<int>(dx), static_cast<int>(dy), 1, state, 0);
  }

  void collect(int index, std::int64_t x, std::int64_t y) {
    const Node& node = nodes_[static_cast<std::size_t>(index)];
    if (index == 0 || node.cells == 0) return;
    if (node.level == 3 && node.leaf) {
      for (int i = 0; i < 64; ++i)
        if ((node.bits >> i & 1U) != 0) cell(x + i % 8, y + i / 8, 1);
      return;
    }
    const std::int64_t half = std::int64_t{1} << (node.level - 1);
    for (int i = 0; i < 4; ++i) {
      const int child = node.children[static_cast<std::size_t>(i)];
      const std::int64_t left = x + (i % 2) * half, top = y + (i / 2) * half;
      if (!node.leaf)
        collect(child, left, top);
      else if (child != 0)
        cell(left, top, child);
    }
  }

  CellPattern fitted() {
    if (pattern_.runs.empty()) return std::move(pattern_);
    constexpr int far = std::numeric_limits<int>::max();
    glm::ivec2 min(far), end(-far);
    for (const CellPattern::Run& run : pattern_.runs) {
      min = {std::min(min.x, run.x), std::min(min.y, run.y)};
      end = {std::max(end.x, run.x + run.length), std::max(end.y, run.y + 1)};
    }
    pattern_.size = end - min;
    if (std::max(pattern_.size.x, pattern_.size.y) > maxLifeSide)
      wrong(0, fmt::format("the living cells are {} x {} apart, more than {}, the maximum", pattern_.size.x,
                           pattern_.size.y, maxLifeSide));
    for (CellPattern::Run& run : pattern_.runs) {
      run.x -= min.x;
      run.y -= min.y;
    }
    if (pattern_.shape) placeInGrid(origin_.first + min.x, origin_.second + min.y);
    return std::move(pattern_);
  }

  /// The centre of the largest square is the centre of the grid. In Golly's file, y points up, so row 0 is
  /// the row above the centre.
  void placeInGrid(std::int64_t x, std::int64_t y) {
    const std::int64_t half = std::int64_t{1} << (nodes_.back().level - 1);
    const auto within = [](std::int64_t place) {
      return static_cast<int>(std::clamp<std::int64_t>(place, -2 * maxLifeSide, 2 * maxLifeSide));
    };
    pattern_.corner = glm::ivec2(within(x - half), within(y - half + 1)) + pattern_.grid / 2;
  }

  std::vector<Node> nodes_;
  std::pair<std::int64_t, std::int64_t> origin_{0, 0};
};

}  // namespace

CellPattern parseMacrocell(std::string_view text, const std::string& name, std::size_t maxCells) {
  return MacrocellReader(text, name).read(maxCells);
}

}  // namespace simreel::sim
