// Compares a fluid with a plain loop. Prints the fluid's buffers, the bytes that a step moves, and the
// times of its parts.
#include "beside/memory.hpp"
#include "beside/subject.hpp"
#include "gl/context.hpp"
#include "plain/plain.hpp"
#include "reference/fluid_twin.hpp"
#include "sim/fluid/kernels.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace simreel::bench {

namespace {

constexpr int tankSide = 512;
constexpr double cells = double(tankSide) * tankSide;

// Bytes per cell that a multigrid cycle moves if every kernel reads and writes each element once. The other
// kernels of a step are added in movedBytes(). The table shows the bytes per cell that each kernel reads
// and writes. An element of flow or dye has 16 bytes on the texel path, and 4 bytes per float on graphics
// cards. An opening, correction, residual or right-hand side has 4 bytes. Brushes are not counted, because
// they touch few cells of this tank. Tiles near walls also read openings, which are not counted either.
//
//                            texel path            graphics cards
//                            read           write  read              write
//   push                     16 + 4         16     16 + 4            12
//   carry                    16 + 4         16     12 + 4            12
//   correct                  16 + 16 + 4    16     12 + 12 + 4 + 4   12
//   divergence               16 + 4         12     8 + 4             12
//   projection               16 + 8         16     12 + 8            12
//   check, paths of dye                            12 + 4            8
//   one pass of dye          16 + 16        16
//   two passes of dye                              12 + 8            12
//
// A cycle reads 4 and writes 5 bytes on the way down, and reads 4 + 1 + 4 and writes 4 bytes on the way up.
// All levels together move 4/3 of the finest level's bytes. The finest level also reads 16 and writes 12
// bytes for the sum with its rounding error.
constexpr double cycleBytes = 22 * 4.0 / 3 + 28;

double movedBytes(const sim::FluidPlan& plan, double cycles) {
  const bool texels = gl::memoryPath() == gl::MemoryPath::texel;
  const int passes = plan.dyePasses();
  const int step = texels ? 36 + 36 + 52 + 32 + 40 : 32 + 28 + 44 + 24 + 32 + 24;
  const int dye = texels ? passes * 48 : (passes + 1) / 2 * 32;
  return step + dye + cycles * cycleBytes;
}

sim::FluidParameters tank(int side) {
  sim::FluidParameters p;
  p.size = {side, side};
  p.speed = 150;
  p.substeps = 1;
  p.lift = 60.0F;
  p.cooling = 0.1F;
  p.strokes.clear();
  for (const plain::Fluid::Jet& jet : plain::Fluid::jetsOf(side, side)) {
    sim::FluidStroke s;
    s.until = 1e6;
    s.from = s.to = {jet.x, jet.y, 0};
    s.radius = jet.radius;
    s.setsVelocity = s.setsDye = s.setsTemperature = true;
    s.velocity = glm::vec3(jet.u, jet.v, 0);
    s.dye = glm::vec3(jet.dye[0], jet.dye[1], jet.dye[2]);
    s.temperature = 1.0F;
    p.strokes.push_back(s);
  }
  p.obstacles.resize(1);
  p.obstacles[0].center = glm::vec3(0.37F * side, 0.5F * side, 0);
  p.obstacles[0].radius = 0.05F * side;
  return p;
}

std::function<void()> stepsOf(const std::shared_ptr<sim::FluidPlan>& plan,
                              const std::shared_ptr<sim::FluidKernels>& kernels) {
  return [plan, kernels, frame = 0]() mutable {
    const double time = frame++ * frameSeconds;
    kernels->beginFrame(time);
    kernels->advance(time, 1, static_cast<unsigned>(frame));
  };
}

/// Prints how long a step takes if one of its parts is left out, as a time and as a percentage of the time
/// `whole` of a full step. Only the device is measured.
void printShares(double whole) {
  const std::pair<const char*, std::function<void(sim::FluidParameters&)>> without[] = {
      {"all cycles but one", [](auto& p) { p.cycles = 1; }},
      {"dye",
       [](auto& p) {
         for (auto& s : p.strokes) s.setsDye = false;
       }},
      {"the second half of MacCormack",
       [](auto& p) { p.advection = sim::FluidParameters::Advection::semiLagrangian; }},
      {"temperature",
       [](auto& p) {
         for (auto& s : p.strokes) s.setsTemperature = false;
       }},
      {"brushes",
       [](auto& p) {
         for (auto& s : p.strokes) s.until = 0;
       }},
  };
  for (const auto& [name, leave] : without) {
    sim::FluidParameters p = tank(tankSide);
    leave(p);
    const auto plan = std::make_shared<sim::FluidPlan>(p, "tank", 1, frameSeconds);
    const auto kernels = std::make_shared<sim::FluidKernels>("tank", *plan, false);
    kernels->start(0);
    const auto steps = stepsOf(plan, kernels);
    for (int i = 0; i < 10; ++i) steps();
    const Taken taken = minimumOf(steps);
    fmt::print("  without {:<30} {:>6.1f} ms of a processor, {:>5.1f}% of the step\n", name,
               1e3 * taken.processor, 100 * taken.processor / whole);
  }
}

}  // namespace

Subject fluidTank() {
  const sim::FluidParameters p = tank(tankSide);
  const GLuint first = nextBuffer();
  const auto plan = std::make_shared<sim::FluidPlan>(p, "tank", 1, frameSeconds);
  const auto kernels = std::make_shared<sim::FluidKernels>("tank", *plan, false);
  kernels->start(0);
  const auto own = std::make_shared<plain::Fluid>(
      tankSide, tankSide,
      plain::Fluid::Numbers{static_cast<float>(frameSeconds), 60,
                            static_cast<float>(1 - 0.1 * frameSeconds), plan->dyePasses()});
  const auto steps = stepsOf(plan, kernels);
  for (int i = 0; i < 10; ++i) {
    own->step();
    steps();
  }
  Subject subject{"fluid 512x512",
                  "1e6 cell-steps/s",
                  cells,
                  [=] { own->step(); },
                  frames(std::make_shared<FluidTwin>(*plan)),
                  steps};
  subject.after = [=] {
    const Taken taken = minimumOf(steps);
    const double cycles = kernels->pressure().report().cycles;
    fmt::print(
        "  {:.1f} whole steps a second, {:.1f} a processor second; {:.1f} cycles (the plain loop {}), {} "
        "passes of dye\n",
        1 / taken.wall, 1 / taken.processor, cycles, own->cycles, plan->dyePasses());
    printBytes(movedBytes(*plan, cycles), cells / taken.processor);
    listBuffers("fluid", first, cells);
    printShares(taken.processor);
  };
  return subject;
}

void printFluidSpeed(int side, int maxCycles) {
  const GLuint first = nextBuffer();
  sim::FluidParameters p = tank(side);
  if (maxCycles > 0) p.cycles = maxCycles;
  const auto plan = std::make_shared<sim::FluidPlan>(p, "tank", 1, frameSeconds);
  const auto kernels = std::make_shared<sim::FluidKernels>("tank", *plan, false);
  kernels->start(0);
  const auto step = stepsOf(plan, kernels);
  constexpr int steps = 5;
  for (int i = 0; i < 2 * steps; ++i) step();
  const double all = double(side) * side;
  double cycles = 0;
  printSpeed(
      fmt::format("fluid {}x{} with RGB, temperature and an obstacle", side, side).c_str(), all, steps,
      [&] {
        for (int i = 0; i < steps; ++i) step();
      },
      [&] {
        cycles = kernels->pressure().report().cycles;
        return movedBytes(*plan, cycles);
      });
  fmt::print("  {:.2f} cycles a projection of {} dispatched, {} passes of dye\n", cycles, p.cycles,
             plan->dyePasses());
  const auto dye = kernels->arrays().dyeState().readAll<glm::vec4>();
  const auto dyed =
      std::count_if(dye.begin(), dye.end(), [](const glm::vec4& c) { return c.x + c.y + c.z > 0; });
  fmt::print("  dye in {:.0f}% of the cells at the end\n", 100 * static_cast<double>(dyed) / all);
  listBuffers("fluid", first, all);
}

}  // namespace simreel::bench
