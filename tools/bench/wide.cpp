// Measures Larger than Life on a torus for any range. Compares two plain loops on one thread, the kernels,
// and the limit of memory bandwidth. Prints cells/s, and ratios to the plain loop that adds up all
// neighbours of each cell.
//
//     bench_wide [WIDTH HEIGHT [RANGE [STEPS]]] [M|N|C] [plain]     defaults 2048 2048 5 8 M
//
// M is for squares, N for diamonds, C for circles; "plain" skips the loops on the CPU
#include "plain/wide.hpp"

#include "beside/memory.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"
#include "sim/automata/engine/cell_engine.hpp"
#include "sim/life/plan.hpp"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include <fmt/format.h>

using namespace simreel;

namespace {

using Clock = std::chrono::steady_clock;

/// Returns the best rate in cells/s of at least two runs that last 0.5 s in total.
template <class Body>
double bestRate(double cells, const Body& body) {
  double best = 0;
  const auto begin = Clock::now();
  for (int i = 0; i < 2 || std::chrono::duration<double>(Clock::now() - begin).count() < 0.5; ++i) {
    const auto start = Clock::now();
    body();
    best = std::max(best, cells / std::chrono::duration<double>(Clock::now() - start).count());
  }
  return best;
}

void line(const char* name, double rate, double direct) {
  fmt::print("{:<44} {:>12.6f}e9 cells/s", name, rate / 1e9);
  if (direct > 0) fmt::print(" ({:.1f} x)", rate / direct);
  fmt::print("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  bool loops = true;
  std::string shape = "M";
  std::vector<int> numbers;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word == "plain")
      loops = false;
    else if (word == "M" || word == "N" || word == "C")
      shape = word;
    else
      numbers.push_back(std::atoi(argv[i]));
  }
  const auto number = [&](std::size_t i, int otherwise) {
    return numbers.size() > i ? numbers[i] : otherwise;
  };
  const glm::ivec2 size(number(0, 2048), number(1, 2048));
  const int range = number(2, 5), steps = number(3, 8);
  if (range < 1 || range > 500 || steps < 1 || std::min(size.x, size.y) <= 2 * range) {
    fmt::print(stderr, "usage: bench_wide [WIDTH HEIGHT [RANGE [STEPS]]] [M|N|C] [plain]\n");
    return 2;
  }
  sim::CellRule around;
  if (!sim::parseCellRule(fmt::format("R{},C0,M1,S1..1,B1..1,N{}", range, shape), around).message.empty())
    return 2;
  plain::Wide::Rule limits;
  int n = 0;
  for (int dy = -range; dy <= range; ++dy) {
    limits.half.push_back(around.wide.span(dy).last);
    n += 2 * limits.half.back() + 1;
  }
  // The limits of Bosco's rule are given for range 5, whose neighbourhood has 121 cells. share() scales
  // them to the `n` cells of this neighbourhood.
  const auto share = [&](int of121) { return static_cast<int>(std::int64_t{n} * of121 / 121); };
  limits.surviveMin = limits.bornMin = share(34);
  limits.surviveMax = share(58);
  limits.bornMax = share(45);
  sim::LifeParameters parameters;
  parameters.size = size;
  parameters.fill = 0.5F;
  parameters.rule = fmt::format("R{},C0,M1,S{}..{},B{}..{},N{}", range, limits.surviveMin,
                                limits.surviveMax, limits.bornMin, limits.bornMax, shape);
  const double cells = static_cast<double>(size.x) * size.y;
  const gl::Context context;
  fmt::print("device: {}\n{} x {} cells, {}\n", context.device().name, size.x, size.y, parameters.rule);
  double direct = 0;
  if (loops) {
    plain::Wide loop(size.x, size.y, limits);
    for (std::size_t i = 0; i < loop.cells.size(); ++i) loop.cells[i] = i * 2654435761U % 97 < 48 ? 1 : 0;
    // For long ranges, only a few rows are measured.
    const int rows = static_cast<int>(std::clamp(1e9 / n / size.x, 1.0, static_cast<double>(size.y)));
    direct = bestRate(static_cast<double>(size.x) * rows, [&] { loop.direct(rows); });
    line("loop over bytes, all around, 1 thread", direct, direct);
    line("loop over bytes, running sums, 1 thread", bestRate(cells, [&] { loop.stepRunning(); }), direct);
  }
  const sim::LifePlan plan(parameters, "cells", 1, 0.1);
  const auto words = plan.firstCells();
  std::vector<glm::uvec4> items(words.size() / 4);
  std::memcpy(items.data(), words.data(), words.size() * 4);
  gl::WordsArray grid[2] = {gl::WordsArray("cells", items), gl::WordsArray("next cells", items)};
  sim::CellEngine engine(plan.rule(), plan.shape(), size, true, "bench");
  const auto run = [&] {
    for (int i = 0; i < steps; ++i) {
      gl::barrier();
      engine.run(grid[i % 2], grid[(i + 1) % 2]);
    }
    glFinish();
  };
  run();
  const double rate = bestRate(cells * steps, run);
  line("device", rate, direct);
  const double copied = bench::copiedBySecond();
  // The bits of the cells are read and written once. Each byte of the engine's buffers is written once and
  // read once. For squares and long ranges, the column sums also read and write the padded cells once, as
  // bytes.
  const bool sums = range > 90 || shape == "M";
  const double bytesPerCell = 2.0 / 8 + 2.0 * static_cast<double>(engine.bytes()) / cells + (sums ? 1 : 0);
  fmt::print(
      "memory copies {:.1f}e9 bytes/s; all passes move {:.1f} bytes a cell: limit {:.3f}e9 cells/s, "
      "{:.1f}% "
      "of it reached; one pass over the bits alone would be {:.1f}e9\n",
      copied / 1e9, bytesPerCell, copied / bytesPerCell / 1e9, 100 * rate * bytesPerCell / copied,
      copied / 0.25 / 1e9);
}
