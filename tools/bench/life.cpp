// Measures generations of B3/S23 on a torus. Compares a loop over bytes, the bit-sliced CPU twin on one
// thread and on all threads, and the kernel with several partitions of the work, all on the same grid.
// Prints cells/s and the ratio to the loop over bytes.
//
//     bench_life [WIDTH HEIGHT [STEPS [plain]]]     defaults 4096 4096 64; "plain" skips the CPU loops
//
// A grid has 2 bits per cell. A pass reads and writes these bits once, however many generations it
// computes.
#include "gl/context.hpp"
#include "gl/element_array.hpp"
#include "plain/plain.hpp"
#include "reference/life_twin.hpp"
#include "sim/life/stepper.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <thread>

#include <fmt/format.h>

using namespace simreel;

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Rates in cells/s, by wall-clock time and by processor time of all threads. Other load on the machine
/// affects processor time less.
struct Rate {
  double wall = 0;
  double processor = 0;
};

/// Runs `body`, which performs `cells` cell updates, at least twice and for 0.4 s. Returns the best rates.
template <class Body>
Rate rate(double cells, const Body& body) {
  Rate best;
  const auto begin = Clock::now();
  for (int i = 0; i < 2 || secondsSince(begin) < 0.4; ++i) {
    const auto start = Clock::now();
    const std::clock_t used = std::clock();
    body();
    best.wall = std::max(best.wall, cells / secondsSince(start));
    best.processor = std::max(
        best.processor,
        cells / (static_cast<double>(std::max<std::clock_t>(1, std::clock() - used)) / CLOCKS_PER_SEC));
  }
  return best;
}

struct Variant {
  const char* name;
  sim::LifeTuning tuning;
};

void print(const std::string& name, Rate found, Rate plain) {
  fmt::print("{:<52} {:>9.3f}e9", name, found.wall / 1e9);
  if (plain.wall > 0)
    fmt::print(" ({:.1f} x)  {:>9.3f}e9 ({:.1f} x)", found.wall / plain.wall, found.processor / 1e9,
               found.processor / plain.processor);
  fmt::print("\n");
  std::fflush(stdout);
}

/// Measures the loop over bytes and the CPU twin on a grid small enough for a CPU. Returns the rate of the
/// loop over bytes.
Rate onCpu(glm::ivec2 size) {
  const double cells = static_cast<double>(size.x) * size.y;
  sim::LifeParameters parameters;
  parameters.size = size;
  LifeTwin twin(sim::LifePlan(parameters, "cells", 1, 0.1));
  plain::Life bytes(size.x, size.y);
  for (std::size_t i = 0; i < bytes.cells.size(); ++i) bytes.cells[i] = i * 2654435761U % 97 < 29 ? 1 : 0;
  const Rate plain = rate(cells, [&] { bytes.step(); });
  print("loop over bytes, -O3, 1 thread", plain, plain);
  const Rate one = rate(4 * cells, [&] {
    for (int i = 0; i < 4; ++i) twin.generation(1);
  });
  print("CPU twin, bits, 1 thread", one, plain);
  const Rate all = rate(4 * cells, [&] {
    for (int i = 0; i < 4; ++i) twin.generation(0);
  });
  print(fmt::format("CPU twin, bits, {} threads", std::thread::hardware_concurrency()), all, plain);
  return plain;
}

/// Returns random cells. One random band is repeated, so that a huge grid is filled quickly.
std::vector<glm::uvec4> soup(glm::ivec2 size) {
  sim::LifeParameters parameters;
  parameters.size = {size.x, std::min(size.y, std::max(1, (1 << 22) / size.x))};
  const auto band = sim::LifePlan(parameters, "cells", 1, 0.1).firstCells();
  const std::size_t words =
      static_cast<std::size_t>(sim::CellRows::rowWords(size.x)) * static_cast<std::size_t>(size.y);
  std::vector<glm::uvec4> items(words / 4);
  for (std::size_t done = 0; done < words; done += band.size())
    std::memcpy(reinterpret_cast<std::uint32_t*>(items.data()) + done, band.data(),
                4 * std::min(band.size(), words - done));
  return items;
}

void onDevice(glm::ivec2 size, int steps, Rate plain) {
  const auto items = soup(size);
  gl::WordsArray cells[2] = {gl::WordsArray("cells", items), gl::WordsArray("next cells", items)};
  fmt::print("memory of the cells: {:.1f} MiB, {:.3f} bits a cell\n",
             static_cast<double>(2 * items.size() * 16) / (1 << 20),
             static_cast<double>(2 * items.size() * 128) / (static_cast<double>(size.x) * size.y));
  const sim::LifeTuning best = sim::LifeTuning::best(size);
  std::vector<Variant> variants = {{"what a scene gets", best}};
  for (const int count : {1, 2, 3, 4, 6})
    for (const int blocks : {1, 2})
      for (const int rows : {32, 64, 128})
        for (const glm::ivec2 group : {glm::ivec2(32, 2), {8, 4}})
          variants.push_back({"", {count, blocks, rows, group}});
  for (const Variant& variant : variants) {
    const sim::LifeTuning& t = variant.tuning;
    sim::LifeStepper stepper({}, true, size, t);
    if (stepper.maxSteps() != t.steps) continue;
    const int passes = std::max(1, steps / t.steps);
    const auto run = [&] {
      for (int i = 0; i < passes; ++i) {
        gl::barrier();
        stepper.run(cells[i % 2], cells[(i + 1) % 2], t.steps);
      }
      glFinish();
    };
    run();
    const Rate found = rate(static_cast<double>(size.x) * size.y * passes * t.steps, run);
    print(fmt::format("device: {} steps, {} blocks, {:>3} rows, {:>2}x{} {}", t.steps, t.blocks, t.rows,
                      t.group.x, t.group.y, variant.name),
          found, plain);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const auto argument = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
  const glm::ivec2 size(argument(1, 4096), argument(2, 4096));
  const int steps = argument(3, 64);
  if (size.x < 1 || size.y < 1 || steps < 1) {
    fmt::print(stderr, "usage: bench_life [WIDTH HEIGHT [STEPS [plain]]]\n");
    return 2;
  }
  const gl::Context context;
  fmt::print("device: {}\n{} x {} cells, {} steps\n", context.device().name, size.x, size.y, steps);
  const Rate plain = argc > 4 ? Rate{} : onCpu({std::min(size.x, 4096), std::min(size.y, 4096)});
  onDevice(size, steps, plain);
}
