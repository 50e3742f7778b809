// Measures Gray-Scott steps on the device with several partitions of the work, compared with the CPU twin
// on one thread and on all threads. One item is a step of one cell. A pass reads and writes u and v of
// every cell, 16 bytes. A step has 35 operations per cell: 16 for two Laplacians, which share sums of
// neighbours (8 each: about 4 additions and 3 multiplications), 3 for the reaction, 12 for the two sums and
// 4 for the bounds. With several steps per pass, a step moves fewer bytes, but the border of each strip is
// computed repeatedly.
//
//     bench_gray_scott [SIDE]     8192 on a GPU, 512 on a software driver
//
// Use --benchmark_filter to measure one line per process: on NVIDIA's driver, large arrays that are created
// after other arrays were freed take up to 1.5 times as long.
//
// With --patterns, prints the result of each preset after 10,000 steps on 129x127 cells, as in the table of
// src/sim/gray_scott/README.md.
#include "gl/context.hpp"
#include "reference/gray_scott_twin.hpp"
#include "sim/gray_scott/kernels.hpp"
#include "sim/gray_scott/quantities.hpp"

#include <cstdlib>
#include <string_view>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

sim::GrayScottPlan planOf(int side) {
  sim::GrayScottParameters p;
  p.size = {side, side};
  p.preset = sim::GrayScottPreset::stripes;
  p.seedCount = side;
  return {p, "dish", 1, 1.0 / 30};
}

void report(benchmark::State& state, int side, int steps) {
  const double cells = static_cast<double>(state.iterations()) * steps * side * side;
  state.counters["cell-steps/s"] = benchmark::Counter(cells, benchmark::Counter::kIsRate);
  state.counters["op/s at 35"] = benchmark::Counter(cells * 35, benchmark::Counter::kIsRate);
}

void device(benchmark::State& state, sim::GrayScottKernels::Cut cut, int steps) {
  const int side = static_cast<int>(state.range(0));
  const sim::GrayScottPlan plan = planOf(side);
  sim::GrayScottKernels kernels("bench", plan, false, cut);
  kernels.setRates(plan.ratesAt(0));
  kernels.advance(steps);
  glFinish();
  for (auto _ : state) {
    kernels.advance(steps);
    glFinish();
  }
  report(state, side, steps);
  const double passes = static_cast<double>(state.iterations()) * steps / cut.stepsPerPass;
  state.counters["bytes/s at 16 B a pass"] =
      benchmark::Counter(passes * 16 * side * side, benchmark::Counter::kIsRate);
}

void twin(benchmark::State& state, int threads) {
  const int side = static_cast<int>(state.range(0));
  GrayScottTwin field(planOf(side));
  const auto rates = field.plan().ratesAt(0);
  for (auto _ : state) field.advance(rates, 8, threads);
  report(state, side, 8);
}

void patterns() {
  const char* names[] = {"spots", "stripes", "maze", "solitons", "unstable", "leopard", "chaos"};
  for (int preset = 0; preset < 7; ++preset) {
    sim::GrayScottParameters p;
    p.size = {129, 127};
    p.preset = static_cast<sim::GrayScottPreset>(preset);
    const sim::GrayScottPlan plan(p, "dish", 1, 1.0 / 30);
    sim::GrayScottKernels kernels(names[preset], plan, false);
    kernels.setRates(plan.ratesAt(0));
    kernels.advance(10000);
    gl::barrier();
    fmt::print("{:9}", names[preset]);
    const auto measured = sim::measureGrayScott(kernels.cells().buffer().readAll<glm::vec4>(), p.size);
    for (std::size_t i = 0; i < measured.size(); ++i)
      fmt::print(" {} {:.4g}", p.quantities()[i].name, measured[i]);
    fmt::print("\n");
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const gl::Context context;
  fmt::print("device: {}\n", context.device().name);
  if (argc > 1 && std::string_view(argv[1]) == "--patterns") {
    patterns();
    return 0;
  }
  const bool software = context.device().software;
  const auto add = [&](const std::string& name, int side, auto function, auto... args) {
    benchmark::RegisterBenchmark(("grayScott/" + name).c_str(), function, args...)
        ->Arg(side)
        ->MeasureProcessCPUTime()
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  };
  const int side = argc > 1 ? std::atoi(argv[1]) : software ? 512 : 8192;
  add("twin/one-thread", side, twin, 1);
  add("twin/all-threads", side, twin, 0);
  const int steps = software ? 8 : 96;
  using Cut = sim::GrayScottKernels::Cut;
  const Cut best = sim::GrayScottKernels::bestCut({side, side});
  const Cut cuts[] = {best,
                      Cut{1, 1, 32, 4},
                      Cut{1, 1, 32, 4, 0},
                      Cut{1, 2, 32, 4},
                      Cut{1, 4, 32, 4},
                      Cut{1, 4, 32, 4, 0},
                      Cut{2, 4, 8, 8},
                      Cut{1, 1, 32, 4, 0, 3, 2, 128},
                      Cut{1, 1, 32, 4, 0, 4, 2, 64},
                      Cut{1, 1, 32, 4, 0, 4, 2, 128},
                      Cut{1, 1, 32, 4, 0, 4, 1, 16},
                      Cut{1, 1, 32, 4, 0, 4, 1, 64},
                      Cut{1, 1, 32, 4, 0, 4, 1, 128},
                      Cut{1, 1, 32, 4, 0, 6, 1, 16},
                      Cut{1, 1, 32, 4, 0, 6, 1, 128},
                      Cut{1, 1, 32, 4, 0, 8, 1, 192},
                      Cut{1, 4, 32, 4, 0, 2, 6, 64},
                      Cut{1, 4, 32, 4, 0, 2, 10, 64},
                      Cut{1, 4, 32, 4, 0, 3, 10, 64},
                      Cut{1, 4, 32, 4, 0, 4, 8, 64},
                      Cut{1, 4, 32, 4, 0, 4, 12, 32},
                      Cut{1, 4, 32, 4, 0, 4, 12, 64},
                      Cut{1, 4, 32, 4, 0, 4, 20, 64},
                      Cut{1, 4, 32, 4, 0, 6, 14, 64}};
  for (const Cut& cut : cuts) {
    if (software != (cut.stripElements > 2) && cut.stepsPerPass > 1) continue;
    const std::string work =
        cut.stepsPerPass > 1 ? fmt::format("{} a pass, strips of {}x{}", cut.stepsPerPass,
                                           64 * cut.stripElements, cut.stripRows)
                             : fmt::format("1 a pass, {}x{} of {}x{}{}", cut.groupX, cut.groupY,
                                           2 * cut.across, cut.rows, cut.bandRows == 0 ? ", no bands" : "");
    const bool first = &cut == &cuts[0];
    add(fmt::format("device/{}{}", first ? "what a scene gets: " : "", work), side, device, cut, steps);
  }
  benchmark::RunSpecifiedBenchmarks();
}
