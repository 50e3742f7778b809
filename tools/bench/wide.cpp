// Larger than Life on a torus, squares of any range: two plain loops of one thread, the kernels, and what
// the memory's bandwidth would allow them. Figures are cells/s; ratios are to the direct loop.
//   bench_wide [WIDTH HEIGHT [RANGE [STEPS [plain]]]]     defaults 2048 2048 5 8; "plain": no loops on the
//   CPU
#include "plain/wide.hpp"

#include "beside/memory.hpp"
#include "gl/context.hpp"
#include "gl/element_array.hpp"
#include "sim/automata/engine/cell_engine.hpp"
#include "sim/life/plan.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <fmt/format.h>

using namespace simreel;

namespace {

using Clock = std::chrono::steady_clock;

/// Best cells/s of at least two runs and 0.5 s.
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
  fmt::print("{:<44} {:>10.3f}e9 cells/s", name, rate / 1e9);
  if (direct > 0) fmt::print(" ({:.1f} x)", rate / direct);
  fmt::print("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const auto argument = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
  const glm::ivec2 size(argument(1, 2048), argument(2, 2048));
  const int range = argument(3, 5), steps = argument(4, 8);
  if (range < 1 || range > 127 || steps < 1 || std::min(size.x, size.y) <= 2 * range) {
    fmt::print(stderr, "usage: bench_wide [WIDTH HEIGHT [RANGE [STEPS [plain]]]]\n");
    return 2;
  }
  // The limits of Bosco's rule (range 5), as shares of the neighbourhood.
  const int n = (2 * range + 1) * (2 * range + 1);
  const plain::Wide::Rule limits{range, n * 34 / 121, n * 58 / 121, n * 34 / 121, n * 45 / 121};
  sim::LifeParameters parameters;
  parameters.size = size;
  parameters.fill = 0.5F;
  parameters.rule = fmt::format("R{},C0,M1,S{}..{},B{}..{},NM", range, limits.surviveMin, limits.surviveMax,
                                limits.bornMin, limits.bornMax);
  const double cells = static_cast<double>(size.x) * size.y;
  const gl::Context context;
  fmt::print("device: {}\n{} x {} cells, {}\n", context.device().name, size.x, size.y, parameters.rule);
  double direct = 0;
  if (argc <= 5) {
    plain::Wide loop(size.x, size.y, limits);
    for (std::size_t i = 0; i < loop.cells.size(); ++i) loop.cells[i] = i * 2654435761U % 97 < 48 ? 1 : 0;
    direct = bestRate(cells, [&] { loop.stepDirect(); });
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
  // Bits in and out, cells as bytes written and read twice, sums of columns written and read.
  constexpr double bytesPerCell = 2.0 / 8 + 3 + 2;
  fmt::print(
      "memory copies {:.1f}e9 bytes/s; three passes move {} bytes a cell: limit {:.3f}e9 cells/s, {:.0f}% "
      "of it "
      "reached; one pass over the bits alone would be {:.1f}e9\n",
      copied / 1e9, bytesPerCell, copied / bytesPerCell / 1e9, 100 * rate * bytesPerCell / copied,
      copied / 0.25 / 1e9);
}
