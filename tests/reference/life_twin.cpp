#include "reference/life_twin.hpp"

#include "reference/states_twin.hpp"
#include "sim/core/shader_code.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace {

using namespace simreel::shader;

#define FUNCTION inline
namespace trails {
#include "glsl/life/trail.glsl"
}
#undef FUNCTION

#define FUNCTION [[gnu::always_inline]] inline
#define WORD std::uint64_t
/// The kernels' logic for a rule that is known at compile time.
template <int B, int S>
struct FixedRule {
  static constexpr int BORN = B;
  static constexpr int SURVIVE = S;
#include "glsl/life/model.glsl"
};
/// The kernels' logic for any rule.
struct AnyRule {
  int BORN;
  int SURVIVE;
#include "glsl/life/model.glsl"
};
#undef WORD
#undef FUNCTION

template <class Body>
void forRows(int rows, int threads, const Body& body) {
  if (threads == 1) {
    body(0, rows);
    return;
  }
  tbb::task_arena arena(threads == 0 ? tbb::task_arena::automatic : threads);
  arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<int>(0, rows, 64),
                      [&](const tbb::blocked_range<int>& range) { body(range.begin(), range.end()); });
  });
}

/// A grid of bits with 64 cells per word. In memory, the first 32 cells are the lower half of the word
/// (little endian).
struct Grid {
  const std::uint32_t* words;
  glm::ivec2 size;
  bool torus;
  int count;  ///< number of 64-bit words in a row

  /// Loads row y into row[1] and the words after it. row[0] and the word after the row receive the
  /// neighbours across the border. Cells outside a dead border are zero.
  void load(int y, std::vector<std::uint64_t>& row) const {
    std::fill(row.begin(), row.end(), 0);
    if (torus) y = (y + size.y) % size.y;
    if (y < 0 || y >= size.y) return;
    const auto length = static_cast<std::size_t>(count);
    std::memcpy(&row[1], words + 2 * length * static_cast<std::size_t>(y), length * 8);
    if (!torus) return;
    const auto last = static_cast<std::size_t>(size.x - 1);
    row[0] = (row[1 + last / 64] >> (last % 64)) << 63;
    const std::uint64_t first = row[1] & 1;
    row[1 + (last + 1) / 64] |= first << ((last + 1) % 64);
  }
};

template <class Rule>
void generations(Rule rule, const Grid& grid, std::uint32_t* out, int firstRow, int endRow) {
  using Sums = typename Rule::RowSum;
  const auto count = static_cast<std::size_t>(grid.count);
  std::vector<std::uint64_t> row(count + 3);
  std::vector<std::uint64_t> alive(count);
  std::vector<std::uint64_t> next(count);
  std::vector<Sums> above(count);
  std::vector<Sums> here(count);
  for (int y = firstRow - 1; y <= endRow; ++y) {
    grid.load(y, row);
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint64_t cells = row[i + 1];
      const Sums below = rule.rowSum(cells << 1 | row[i] >> 63, cells, cells >> 1 | row[i + 2] << 63);
      next[i] = rule.nextCells(above[i], here[i], below, alive[i]);
      above[i] = here[i];
      here[i] = below;
      alive[i] = cells;
    }
    if (y <= firstRow) continue;
    const auto whole = static_cast<std::size_t>(grid.size.x) / 64;
    if (whole < count) next[whole] &= (std::uint64_t{1} << (grid.size.x % 64)) - 1;
    for (std::size_t i = whole + 1; i < count; ++i) next[i] = 0;
    std::memcpy(out + 2 * count * static_cast<std::size_t>(y - 1), next.data(), count * 8);
  }
}

}  // namespace

std::vector<std::uint8_t> nextBytes(const std::vector<std::uint8_t>& cells, glm::ivec2 size,
                                    const simreel::sim::LifeRule& rule, bool torus) {
  std::vector<std::uint8_t> next(cells.size());
  const auto at = [&](int x, int y) -> int {
    if (torus) {
      x = (x + size.x) % size.x;
      y = (y + size.y) % size.y;
    } else if (x < 0 || y < 0 || x >= size.x || y >= size.y) {
      return 0;
    }
    return cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) +
                 static_cast<std::size_t>(x)];
  };
  std::size_t i = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x, ++i) {
      int neighbours = -at(x, y);
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) neighbours += at(x + dx, y + dy);
      next[i] = static_cast<std::uint8_t>((cells[i] != 0 ? rule.survives : rule.born) >> neighbours & 1);
    }
  return next;
}

void fastBytes(std::vector<std::uint8_t>& cells, std::vector<std::uint8_t>& next, glm::ivec2 size) {
  const auto width = static_cast<std::size_t>(size.x);
  const auto height = static_cast<std::size_t>(size.y);
  const std::size_t pitch = width + 2;
  for (std::size_t y = 1; y <= height; ++y) {
    cells[y * pitch] = cells[y * pitch + width];
    cells[y * pitch + width + 1] = cells[y * pitch + 1];
  }
  std::memcpy(&cells[0], &cells[height * pitch], pitch);
  std::memcpy(&cells[(height + 1) * pitch], &cells[pitch], pitch);
  for (std::size_t y = 1; y <= height; ++y) {
    const std::uint8_t* a = &cells[(y - 1) * pitch];
    const std::uint8_t* b = a + pitch;
    const std::uint8_t* c = b + pitch;
    std::uint8_t* out = &next[y * pitch];
    for (std::size_t x = 1; x <= width; ++x) {
      const auto n = static_cast<std::uint8_t>(a[x - 1] + a[x] + a[x + 1] + b[x - 1] + b[x + 1] + c[x - 1] +
                                               c[x] + c[x + 1]);
      out[x] = static_cast<std::uint8_t>((n | b[x]) == 3);  // True if n is 3, or if n is 2 and the cell is
                                                            // alive. n is the number of living neighbours.
    }
  }
}

std::vector<std::uint8_t> bytesOf(const std::vector<std::uint32_t>& words, glm::ivec2 size) {
  const simreel::sim::CellRows rows{size, words};
  std::vector<std::uint8_t> cells;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) cells.push_back(rows.alive(x, y) ? 1 : 0);
  return cells;
}

std::vector<std::uint32_t> wordsOf(const std::vector<std::uint8_t>& cells, glm::ivec2 size) {
  const auto rowWords = static_cast<std::size_t>(simreel::sim::CellRows::rowWords(size.x));
  std::vector<std::uint32_t> words(rowWords * static_cast<std::size_t>(size.y));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::size_t x = i % static_cast<std::size_t>(size.x);
    const std::size_t y = i / static_cast<std::size_t>(size.x);
    words[y * rowWords + x / 32] |= static_cast<std::uint32_t>(cells[i]) << (x % 32);
  }
  return words;
}

LifeTwin::LifeTwin(simreel::sim::LifePlan plan, double start)
    : words(plan.firstCells()), plan_(std::move(plan)), next_(words) {
  const glm::ivec2 size = plan_.parameters().size;
  paint(plan_.generationAt(plan_.frameAt(start)));
  if (plan_.parameters().trail == 0) return;
  trail.resize(static_cast<std::size_t>((size.x + 15) / 16 * 4) * static_cast<std::size_t>(size.y));
  fade();
}

void LifeTwin::generation(int threads) {
  if (!plan_.plain() || plan_.rule().family != simreel::sim::CellRule::Family::counts) {
    const glm::ivec2 size = plan_.parameters().size;
    words = wordsOf(nextStates(bytesOf(words, size), size, plan_.rule(), plan_.shape()), size);
    return;
  }
  const simreel::sim::LifeRule& rule = plan_.rule().counts;
  const Grid grid{words.data(), plan_.parameters().size, plan_.torus(), plan_.rowBlocks() * 2};
  forRows(grid.size.y, threads, [&](int first, int end) {
    constexpr FixedRule<8, 12> conway;
    if (rule.born == conway.BORN && rule.survives == conway.SURVIVE)
      generations(conway, grid, next_.data(), first, end);
    else
      generations(AnyRule{rule.born, rule.survives}, grid, next_.data(), first, end);
  });
  std::swap(words, next_);
}

void LifeTwin::paint(long generation) {
  const glm::ivec2 size = plan_.parameters().size;
  for (const Stroke& stroke : plan_.strokesInto(generation))
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        if (!plan_.strokes().paints(stroke, {x, y})) continue;
        std::uint32_t& word = words[static_cast<std::size_t>(y * plan_.rowBlocks() * 4 + x / 32)];
        const std::uint32_t bit = 1U << (x % 32);
        word = stroke.value < 0.5F ? word & ~bit : word | bit;
      }
}

void LifeTwin::step(double time, int threads) {
  const long frame = plan_.frameAt(time);
  for (long g = plan_.generationAt(frame); g < plan_.generationAt(frame + 1); ++g) {
    generation(threads);
    paint(g + 1);
    if (!trail.empty()) fade();
  }
}

void LifeTwin::fade() {
  const auto& p = plan_.parameters();
  const auto rowWords = (p.size.x + 15) / 16 * 4;
  const auto bright = static_cast<std::uint32_t>(p.brightLevel());
  const auto drop = bright - static_cast<std::uint32_t>(p.trail);
  for (int y = 0; y < p.size.y; ++y)
    for (int i = 0; i < rowWords; ++i) {
      const std::uint32_t word = words[static_cast<std::size_t>(y * plan_.rowBlocks() * 4 + i / 8)];
      std::uint32_t& bytes = trail[static_cast<std::size_t>(y * rowWords + i)];
      bytes = trails::fadedTrail(bytes, word >> (i % 8 * 4), bright, drop);
    }
}
