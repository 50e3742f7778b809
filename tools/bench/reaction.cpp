// Measures steps of a rule that a scene defines as expressions (Gray-Scott's equations). Compares them with
// the hand-written kernels of the same stencil, the expression evaluator on the CPU, a plain loop, and the
// limit of memory bandwidth. One item is a step of one cell. A pass reads and writes two floats per cell,
// 16 bytes.
//
//     bench_reaction [SIDE]     8192 on a GPU, 512 on a software driver
//
// The lines "volume" measure the same in a volume with 64 cells per side, or 256 on a GPU.
//
// First prints how long the kernels of each preset take from their source text to their first steps. Set
// MESA_SHADER_CACHE_DISABLE=1 to exclude the driver's cache.
#include "gl/context.hpp"
#include "plain/plain.hpp"
#include "sim/gray_scott/kernels.hpp"
#include "sim/reaction/kernels.hpp"
#include "sim/reaction/presets.hpp"

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

constexpr double frameSeconds = 1.0 / 30;

sim::GrayScottPlan byHand(int side) {
  sim::GrayScottParameters p;
  p.size = {side, side};
  p.preset = sim::GrayScottPreset::stripes;
  p.seedCount = side;
  return {p, "dish", 1, frameSeconds};
}

/// Returns the plan of a rule with Gray-Scott's equations. Its diffusion coefficients are 0.3 times the
/// coefficients of the hand-written kernels, because its Laplacian is 1 / 0.3 times as large.
sim::ReactionPlan asRule(int side) {
  sim::ReactionParameters p;
  p.size = {side, side};
  p.dt = 1;
  p.species.resize(2);
  p.species[0].name = "u";
  p.species[0].diffusion = 0.063F;
  p.species[0].rate = "feed*(1 - u) - u*v^2";
  p.species[0].start = "1 - 0.4*abs(random(1))";
  p.species[1].name = "v";
  p.species[1].diffusion = 0.0315F;
  p.species[1].rate = "u*v^2 - (feed + kill)*v";
  p.species[1].start = "0.4*abs(random(1))";
  p.parameters.resize(2);
  p.parameters[0].name = "feed";
  p.parameters[0].value = 0.04F;
  p.parameters[1].name = "kill";
  p.parameters[1].value = 0.06F;
  return {p, "dish", 1, frameSeconds};
}

sim::ReactionPlan inVolume(int side) {
  sim::ReactionParameters p = asRule(side).parameters();
  p.depth = side;
  return {p, "tank", 1, frameSeconds};
}

sim::ReactionPlan closed(int side) {
  sim::ReactionParameters p = asRule(side).parameters();
  p.boundary = sim::RuleBoundary::noFlux;
  return {p, "dish", 1, frameSeconds};
}

/// Returns a rule of cyclic competition, in which each species is displaced by the next (May and Leonard
/// 1975).
sim::ReactionPlan inCircle(int side, int species) {
  sim::ReactionParameters p;
  p.size = {side, side};
  p.dt = 0.1;
  const auto name = [&](int i) { return fmt::format("u{}", i % species); };
  for (int i = 0; i < species; ++i) {
    sim::ReactionSpecies& one = p.species.emplace_back();
    one.name = name(i);
    one.diffusion = 0.3F;
    one.rate = fmt::format("{0}*(1 - {0} - 2*{1} - 0.5*{2})", name(i), name(i + 1), name(i + 2));
    one.start = fmt::format("0.5*abs(random({}))", i);
  }
  return {p, "dish", 1, frameSeconds};
}

void report(benchmark::State& state, int side, int steps, int depth = 1) {
  const double cells = static_cast<double>(state.iterations()) * steps * side * side * depth;
  state.counters["cell-steps/s"] = benchmark::Counter(cells, benchmark::Counter::kIsRate);
}

void handWritten(benchmark::State& state, sim::GrayScottKernels::Cut cut, int steps) {
  const int side = static_cast<int>(state.range(0));
  const sim::GrayScottPlan plan = byHand(side);
  sim::GrayScottKernels kernels("bench", plan, false, cut);
  kernels.setRates(plan.ratesAt(0));
  kernels.advance(steps);
  glFinish();
  for (auto _ : state) {
    kernels.advance(steps);
    glFinish();
  }
  report(state, side, steps);
}

void rule(benchmark::State& state, sim::ReactionPlan (*make)(int side), sim::WorkSplit cut, int steps) {
  const int side = static_cast<int>(state.range(0));
  const sim::ReactionPlan plan = make(side);
  sim::ReactionKernels kernels("bench", plan, false, cut);
  kernels.setValues(plan.valuesAt(0));
  kernels.advance(0, steps, 0);
  glFinish();
  for (auto _ : state) {
    kernels.advance(0, steps, 0);
    glFinish();
  }
  report(state, side, steps, plan.parameters().depth);
}

void plainVolume(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  plain::GrayScottVolume field(side);
  const auto n = static_cast<std::size_t>(side);
  for (std::size_t i = 0; i < n; ++i) field.v[(i * n + i) * n + n / 2] = 0.5F;
  for (auto _ : state) field.step(0.21F, 0.105F, 0.04F, 0.06F, 1);
  report(state, side, 1, side);
}

void evaluator(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  const sim::ReactionPlan plan = asRule(side);
  sim::RuleField field = plan.firstField();
  const auto values = plan.valuesAt(0);
  for (auto _ : state) sim::evaluateStep(plan, values, 0, 0, field);
  report(state, side, 1);
}

void plainLoop(benchmark::State& state) {
  const int side = static_cast<int>(state.range(0));
  plain::GrayScott field(side, side);
  for (int i = 0; i < side; ++i)
    field.v[static_cast<std::size_t>(i) * static_cast<std::size_t>(side) / 2] = 0.5F;
  for (auto _ : state) field.step(0.21F, 0.105F, 0.04F, 0.06F, 1);
  report(state, side, 1);
}

/// Copies four planes of memory on the processor. This moves the bytes of a step without computing
/// anything.
void bytesAlone(benchmark::State& state, bool volume) {
  const int side = static_cast<int>(state.range(0)), depth = volume ? side : 1;
  const std::size_t cells =
      2 * static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * static_cast<std::size_t>(depth);
  std::vector<float> from(cells, 1.0F), to(cells);
  for (auto _ : state) {
    for (std::size_t i = 0; i < cells; ++i) to[i] = from[i];
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
    std::swap(from, to);
  }
  report(state, side, 1, depth);
}

void compileTimes() {
  for (const sim::ReactionPreset& preset : sim::reactionPresets()) {
    sim::ReactionParameters p;
    preset.apply(p);
    p.size = {64, 64};
    const sim::ReactionPlan plan(p, preset.name, 1, frameSeconds);
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t worked = std::clock();
    sim::ReactionKernels kernels(preset.name, plan, false);
    kernels.setValues(plan.valuesAt(0));
    kernels.advance(0, 8, 0);
    glFinish();
    const std::chrono::duration<double, std::milli> ms = std::chrono::steady_clock::now() - begin;
    const double processor = 1e3 * static_cast<double>(std::clock() - worked) / CLOCKS_PER_SEC;
    const std::size_t programs = plan.program().passes.size();
    fmt::print("{:20} {:7.1f} ms to its first steps, {:6.1f} of a processor, {} programs: {:6.1f} each\n",
               preset.name, ms.count(), processor, programs, processor / static_cast<double>(programs));
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  const gl::Context context;
  fmt::print("device: {}\n", context.device().name);
  compileTimes();
  const bool software = context.device().software;
  const auto add = [&](const std::string& name, int side, auto function, auto... args) {
    benchmark::RegisterBenchmark(("reaction/" + name).c_str(), function, args...)
        ->Arg(side)
        ->MeasureProcessCPUTime()
        ->UseRealTime()
        ->Unit(benchmark::kMillisecond);
  };
  const int side = argc > 1 ? std::atoi(argv[1]) : software ? 512 : 8192;
  const int steps = software ? 8 : 96;
  using Cut = sim::GrayScottKernels::Cut;
  const Cut single = software ? Cut{1, 4, 32, 4, 0} : Cut{1, 1, 32, 4};
  add("by hand, one step a pass", side, handWritten, single, steps);
  add("by hand, several steps a pass", side, handWritten, sim::GrayScottKernels::bestCut({side, side}),
      steps);
  for (const int rows : {1, 2, 4, 8})
    add(fmt::format("rule, one step a pass, {} rows", rows), side, rule, asRule, sim::WorkSplit{rows},
        steps);
  for (const int elements : software ? std::vector<int>{4, 6, 8} : std::vector<int>{1, 2})
    for (const int together : {2, 4}) {
      sim::WorkSplit cut = sim::ReactionKernels::bestCut();
      cut.stripsAfter = 0;
      cut.stepsPerPass = together;
      cut.stripElements = elements;
      add(fmt::format("rule, {} steps a pass, {} elements", together, elements), side, rule, asRule, cut,
          steps);
    }
  using Make = sim::ReactionPlan (*)(int side);
  const std::pair<const char*, Make> others[] = {{"closed", closed},
                                                 {"3 species", [](int s) { return inCircle(s, 3); }},
                                                 {"4 species", [](int s) { return inCircle(s, 4); }},
                                                 {"6 species", [](int s) { return inCircle(s, 6); }},
                                                 {"8 species", [](int s) { return inCircle(s, 8); }}};
  for (const auto& [what, make] : others) {
    sim::WorkSplit cut = sim::ReactionKernels::bestCut();
    cut.stepsPerPass = 1;
    add(fmt::format("{}, one step a pass", what), side, rule, make, cut, steps);
    cut = sim::ReactionKernels::bestCut();
    cut.stripSpecies = sim::maxSpecies;
    cut.stripsAfter = 0;
    for (const int elements : software ? std::vector<int>{3, 4, 6} : std::vector<int>{1})
      for (const int together : {2, 4}) {
        cut.stepsPerPass = together;
        cut.stripElements = elements;
        add(fmt::format("{}, {} steps a pass, {} elements", what, together, elements), side, rule, make,
            cut, steps);
      }
  }
  add("evaluator, one thread", side, evaluator);
  add("plain loop, one thread", side, plainLoop);
  add("bytes alone, one thread", side, bytesAlone, false);
  const int tank = software ? 64 : 256;
  for (const int rows : {1, 2, 4, 8, 16, 32}) {
    sim::WorkSplit cut = sim::ReactionKernels::bestCut();
    cut.volumeRows = rows;
    add(fmt::format("volume, {} rows", rows), tank, rule, inVolume, cut, steps);
  }
  add("volume, plain loop, one thread", tank, plainVolume);
  add("volume, bytes alone, one thread", tank, bytesAlone, true);
  benchmark::RunSpecifiedBenchmarks();
}
