#include "sim/fluid/levels.hpp"

#include "sim/fluid/model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simreel::sim {

namespace {

/// Remaining opening of a coarse face beside a wall that lies within a coarse cell. The opening is not 0,
/// because otherwise regions could become disconnected on the coarse grid only and would then have no
/// solution there.
constexpr double throughWalls = 0.15;

}  // namespace

struct FluidLevels::Grid {
  glm::ivec2 cells;
  std::vector<double> widths, heights;  ///< Widths of columns and heights of rows, in units of fine cells.
  std::vector<double> left, top;        ///< Open lengths of left faces, (cells.x + 1) x cells.y, and of top
                                        ///< faces, cells.x x (cells.y + 1).
  glm::bvec2 wraps;

  [[nodiscard]] double& leftAt(int x, int y) { return left[index(x, y, cells.x + 1)]; }
  [[nodiscard]] double& topAt(int x, int y) { return top[index(x, y, cells.x)]; }
  [[nodiscard]] static std::size_t index(int x, int y, int width) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }

  /// Returns 1 / distance between the centres of the two cells at a face.
  [[nodiscard]] static double perDistance(const std::vector<double>& sizes, int face, bool wraps) {
    const auto count = static_cast<int>(sizes.size());
    const double first = sizes.front(), last = sizes.back();
    if (face == 0) return wraps ? 2 / (last + first) : 2 / first;
    if (face == count) return wraps ? 2 / (last + first) : 2 / last;
    return 2 / (sizes[static_cast<std::size_t>(face) - 1] + sizes[static_cast<std::size_t>(face)]);
  }

  [[nodiscard]] Grid coarser() {
    Grid c;
    c.cells = (cells + 1) / 2;
    c.wraps = wraps;
    const auto joined = [](const std::vector<double>& sizes) {
      std::vector<double> all;
      for (std::size_t i = 0; i < sizes.size(); i += 2)
        all.push_back(sizes[i] + (i + 1 < sizes.size() ? sizes[i + 1] : 0));
      return all;
    };
    c.widths = joined(widths);
    c.heights = joined(heights);
    c.left.resize(static_cast<std::size_t>(c.cells.x + 1) * static_cast<std::size_t>(c.cells.y));
    c.top.resize(static_cast<std::size_t>(c.cells.x) * static_cast<std::size_t>(c.cells.y + 1));
    for (int y = 0; y < cells.y; ++y)
      for (int x = 0; x <= c.cells.x; ++x)
        c.leftAt(x, y / 2) += (isWalledX(2 * x - 1, y) || isWalledX(2 * x + 1, y) ? throughWalls : 1) *
                              leftAt(std::min(2 * x, cells.x), y);
    for (int y = 0; y <= c.cells.y; ++y)
      for (int x = 0; x < cells.x; ++x)
        c.topAt(x / 2, y) += (isWalledY(x, 2 * y - 1) || isWalledY(x, 2 * y + 1) ? throughWalls : 1) *
                             topAt(x, std::min(2 * y, cells.y));
    return c;
  }

  /// Returns true if a face is closed and each of its two cells has another open face. Such a wall lies
  /// within a coarse cell, and that coarse cell must not connect its two sides.
  [[nodiscard]] bool isWalledX(int x, int y) {
    if (wraps.x) x = (x + cells.x) % cells.x;
    if (x <= 0 || x >= cells.x) return false;
    return leftAt(x, y) == 0 && isOpen(x - 1, y) && isOpen(x, y);
  }
  [[nodiscard]] bool isWalledY(int x, int y) {
    if (wraps.y) y = (y + cells.y) % cells.y;
    if (y <= 0 || y >= cells.y) return false;
    return topAt(x, y) == 0 && isOpen(x, y - 1) && isOpen(x, y);
  }
  [[nodiscard]] bool isOpen(int x, int y) {
    return leftAt(x, y) > 0 || leftAt(x + 1, y) > 0 || topAt(x, y) > 0 || topAt(x, y + 1) > 0;
  }
};

void FluidLevels::add(const Grid& g) {
  FluidLevel level;
  level.cells = g.cells;
  level.start = levels_.empty() ? 0 : elements();
  levels_.push_back(level);
  weights_.resize(static_cast<std::size_t>(elements()), glm::uvec4(0));
  const auto fixed = [](double weight) {
    return static_cast<unsigned>(std::min<long>(std::lround(weight * 4096), 65535));
  };
  const auto word = [&](int x, int y) -> unsigned& {
    const int block = level.start + y / 2 * level.blocks().x + x / 2;
    return weights_[static_cast<std::size_t>(block)][y % 2 * 2 + x % 2];
  };
  for (int y = 0; y < g.cells.y; ++y)
    for (int x = 0; x <= g.cells.x; ++x)
      word(x, y) |=
          fixed(g.left[Grid::index(x, y, g.cells.x + 1)] * Grid::perDistance(g.widths, x, g.wraps.x));
  for (int y = 0; y <= g.cells.y; ++y)
    for (int x = 0; x < g.cells.x; ++x)
      word(x, y) |= fixed(g.top[Grid::index(x, y, g.cells.x)] * Grid::perDistance(g.heights, y, g.wraps.y))
                    << 16U;
}

std::vector<std::uint8_t> FluidLevels::openBlocks(const FluidLevel& level) const {
  constexpr std::uint32_t whole = 4096U | 4096U << 16U;
  constexpr int reach = 2;
  std::vector<std::uint8_t> open(static_cast<std::size_t>(level.elements()));
  const glm::ivec2 inside = level.cells / 2;
  std::vector<int> columns(static_cast<std::size_t>(
      inside.x));  // Number of consecutive fully open blocks in each column, up to the current row.
  for (int y = 0; y < inside.y; ++y) {
    int along = 0;  // Number of consecutive columns with enough fully open blocks.
    for (int x = 0; x < inside.x; ++x) {
      const int number = y * level.blocks().x + x, among = level.start + number;
      int& column = columns[static_cast<std::size_t>(x)];
      const glm::uvec4& faces = weights_[static_cast<std::size_t>(among)];
      column = faces == glm::uvec4(whole) ? column + 1 : 0;
      along = column > 2 * reach ? along + 1 : 0;
      const int middle = number - reach * (level.blocks().x + 1);
      if (along > 2 * reach) open[static_cast<std::size_t>(middle)] = 1;
    }
  }
  return open;
}

std::vector<glm::uvec4> FluidLevels::tileLists(std::vector<glm::ivec2>& counts) const {
  std::vector<glm::uvec4> words;
  counts.clear();
  for (const FluidLevel& level : levels_) {
    const std::vector<std::uint8_t> open = openBlocks(level);
    const glm::ivec2 tiles = level.tiles(), blocks = level.blocks();
    const auto start = static_cast<int>(words.size());
    const int end = start + 2 * level.listElements();
    words.resize(static_cast<std::size_t>(end), glm::uvec4(~0U));
    glm::ivec2 found(0, 0);
    for (int ty = 0; ty < tiles.y; ++ty)
      for (int tx = 0; tx < tiles.x; ++tx) {
        const glm::ivec2 first = FluidLevel::tileBlocks * glm::ivec2(tx, ty);
        const glm::ivec2 beyond = glm::min(first + FluidLevel::tileBlocks, (level.cells + 1) / 2);
        bool isOpen = level.hasOpenTiles();
        for (int y = first.y; y < beyond.y && isOpen; ++y)
          for (int x = first.x; x < beyond.x && isOpen; ++x) {
            const int number = y * blocks.x + x;
            isOpen = open[static_cast<std::size_t>(number)] != 0;
          }
        const int which = isOpen ? 0 : 1;
        const int at = found[which]++, element = start + which * level.listElements() + at / 4;
        words[static_cast<std::size_t>(element)][at % 4] =
            static_cast<unsigned>(tx) | static_cast<unsigned>(ty) << 16U;
      }
    counts.push_back((found + FluidLevel::groupTiles - 1) / FluidLevel::groupTiles);
  }
  return words;
}

FluidLevels::FluidLevels(glm::ivec2 size, std::vector<double> left, std::vector<double> top,
                         glm::bvec2 wraps) {
  Grid g;
  g.cells = size;
  g.wraps = wraps;
  g.widths.assign(static_cast<std::size_t>(size.x), 1);
  g.heights.assign(static_cast<std::size_t>(size.y), 1);
  g.left = std::move(left);
  g.top = std::move(top);
  add(g);
  while (std::int64_t{g.cells.x} * g.cells.y > shader::bottomCells) {
    g = g.coarser();
    add(g);
  }
}

}  // namespace simreel::sim
