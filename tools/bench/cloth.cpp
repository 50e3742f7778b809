// Measures cloth substeps on the device and on the CPU twin, with one thread and with all threads. One item
// is one particle in one step. A substep with springs moves 64 bytes per particle, because it reads and
// writes position and velocity. Neighbours' positions are assumed to be cached.
#include "gl/context.hpp"
#include "reference/cloth_twin.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string_view>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

using namespace simreel;

namespace {

int substeps =
    8;  ///< substeps per frame (--substeps N); the benchmark waits for the device after each frame

sim::ClothParameters sheet(int side) {
  sim::ClothParameters p;
  p.size = {side, side};
  p.spacing = 3.2F / static_cast<float>(side);
  p.substeps = substeps;
  return p;
}

void report(benchmark::State& state, int side) {
  const double steps = static_cast<double>(state.iterations()) * substeps * side * side;
  state.counters["particle-steps/s"] = benchmark::Counter(steps, benchmark::Counter::kIsRate);
  state.counters["bytes/s at 64 B"] = benchmark::Counter(steps * 64, benchmark::Counter::kIsRate);
}

void device(benchmark::State& state, bool fast, bool constraints) {
  const int side = static_cast<int>(state.range(0));
  auto p = sheet(side);
  if (constraints) p.solver = sim::ClothSolver::constraints;
  scene::Object object;
  object.name = "sheet";
  object.parameters = std::make_unique<sim::ClothParameters>(p);
  const std::vector<sim::ColliderShape> colliders;
  const auto cloth = sim::simulations()[0].make(object, {fast, 1, 1.0 / 60, &colliders});
  cloth->step(0, {});
  glFinish();
  for (auto _ : state) {
    cloth->step(0, {});
    glFinish();
  }
  report(state, side);
}

void twin(benchmark::State& state, int threads) {
  const int side = static_cast<int>(state.range(0));
  ClothTwin cloth(sim::ClothPlan(sheet(side), 1, 1.0 / 60, {}));
  for (auto _ : state) cloth.step(0, threads);
  report(state, side);
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc == 3 && std::string_view(argv[1]) == "--substeps") substeps = std::max(1, std::atoi(argv[2]));
  const gl::Context context;
  fmt::print("device: {}\n", context.device().name);
  const bool software = context.device().software;
  for (const int side : {256, 1024}) {
    if (software && side > 256) continue;
    const auto add = [&](const char* name, auto function, auto... args) {
      benchmark::RegisterBenchmark(name, function, args...)
          ->Arg(side)
          ->UseRealTime()
          ->Unit(benchmark::kMillisecond);
    };
    add("cloth/twin/one-thread", twin, 1);
    add("cloth/twin/all-threads", twin, 0);
    add("cloth/device/springs", device, false, false);
    add("cloth/device/springs-fast", device, true, false);
    add("cloth/device/constraints", device, false, true);
  }
  benchmark::RunSpecifiedBenchmarks();
}
