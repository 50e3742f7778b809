#include "sim/fluid/levels.hpp"

#include "sim/fluid/model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simreel::sim {

struct FluidLevels::Grid {
  glm::ivec2 cells;
  std::vector<double> widths, heights;  ///< fine cells
  std::vector<double> left, top;  ///< open lengths: (cells.x + 1) x cells.y and cells.x x (cells.y + 1)
  glm::bvec4 open;
  glm::bvec2 wraps;

  [[nodiscard]] double& leftAt(int x, int y) { return left[index(x, y, cells.x + 1)]; }
  [[nodiscard]] double& topAt(int x, int y) { return top[index(x, y, cells.x)]; }
  [[nodiscard]] static std::size_t index(int x, int y, int width) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }

  /// 1 / distance of the middles on both sides of face i.
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
    c.open = open;
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
      for (int x = 0; x <= c.cells.x; ++x) c.leftAt(x, y / 2) += leftAt(std::min(2 * x, cells.x), y);
    for (int y = 0; y <= c.cells.y; ++y)
      for (int x = 0; x < cells.x; ++x) c.topAt(x / 2, y) += topAt(x, std::min(2 * y, cells.y));
    return c;
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

FluidLevels::FluidLevels(glm::ivec2 size, const std::vector<std::uint8_t>& solid, glm::bvec4 open,
                         glm::bvec2 wraps) {
  Grid g;
  g.cells = size;
  g.open = open;
  g.wraps = wraps;
  g.widths.assign(static_cast<std::size_t>(size.x), 1);
  g.heights.assign(static_cast<std::size_t>(size.y), 1);
  g.left.resize(static_cast<std::size_t>(size.x + 1) * static_cast<std::size_t>(size.y));
  g.top.resize(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y + 1));
  const auto free = [&](int x, int y) { return solid[Grid::index(x, y, size.x)] == 0; };
  // A cell beyond the border is as the side is; on a torus it is the one opposite.
  const auto freeAt = [&](int x, int y) {
    if (x < 0) return wraps.x ? free(size.x - 1, y) : open[0];
    if (x >= size.x) return wraps.x ? free(0, y) : open[1];
    if (y < 0) return wraps.y ? free(x, size.y - 1) : open[2];
    if (y >= size.y) return wraps.y ? free(x, 0) : open[3];
    return free(x, y);
  };
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x <= size.x; ++x) g.leftAt(x, y) = freeAt(x - 1, y) && freeAt(x, y) ? 1 : 0;
  for (int y = 0; y <= size.y; ++y)
    for (int x = 0; x < size.x; ++x) g.topAt(x, y) = freeAt(x, y - 1) && freeAt(x, y) ? 1 : 0;
  add(g);
  while (std::int64_t{g.cells.x} * g.cells.y > shader::bottomCells) {
    g = g.coarser();
    add(g);
  }
}

}  // namespace simreel::sim
