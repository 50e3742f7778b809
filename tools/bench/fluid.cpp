// Compares fluids with published flows, which were computed or measured.
//
//   bench_fluid cylinder [CELLS [SECONDS]]   case 2D-2 of Schaefer and Turek, CELLS per diameter (40)
//   bench_fluid wide [CELLS [SECONDS]]       a cylinder at Re 100 in a channel of 30 diameters (12)
//   bench_fluid cavity [CELLS [RE]]          Ghia, Ghia and Shin, 128 cells, Re 1000; and Botella and
//                                            Peyret at Re 1000
//   bench_fluid quick                        all of them at low resolution, in a few seconds
//
// Also measures the speed on this device, one case per process: cell-steps per second, bytes moved compared
// with copying, and the bytes per cell of every buffer.
//
//   bench_fluid speed [SIDE [CYCLES [PATH]]] a fluid, SIDE 4096 on a GPU, 512 on a software driver; at
//                                            most CYCLES per projection (0: the default), for the cost
//                                            of empty cycles; PATH: memory path "storage" or "texel"
//   bench_fluid water [SIDE]                 water, SIDE 8192 on a GPU, 1024 on a software driver
//
// The exit code is 1 if a figure misses the required value.
#include "beside/memory.hpp"
#include "beside/subject.hpp"
#include "gl/context.hpp"
#include "reference/fluid_flows.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <glm/vec4.hpp>

using namespace simreel;

namespace {

std::unique_ptr<sim::Simulation> fluidOf(const sim::FluidParameters& parameters, double frame) {
  scene::Object object;
  object.name = "fluid";
  object.parameters = std::make_unique<sim::FluidParameters>(parameters);
  static const std::vector<sim::ColliderShape> none;
  return sim::simulationNamed("fluid").make(object, {false, 1, frame, &none});
}

struct Range {
  double minimum, maximum;
};

bool within(const char* what, double value, Range bar) {
  const bool fine = value >= bar.minimum && value <= bar.maximum;
  fmt::print("  {:<22} {:>9.5f}   bar {:.5g} to {:.5g}{}\n", what, value, bar.minimum, bar.maximum,
             fine ? "" : "  beyond");
  return fine;
}

flows::Wake wakeOf(const flows::Cylinder& cylinder, double seconds) {
  const auto fluid = fluidOf(cylinder.parameters, cylinder.frame);
  fmt::print("  {}x{} cells, {} substeps of {:.4g} s\n", cylinder.parameters.size.x,
             cylinder.parameters.size.y, fluid->stepsPerFrame(), cylinder.frame / fluid->stepsPerFrame());
  flows::Wake wake;
  std::vector<double> measured;
  for (int frame = 0; frame * cylinder.frame < seconds; ++frame) {
    fluid->pass(frame * cylinder.frame);
    measured = fluid->measure();
    flows::note(wake, cylinder, (frame + 1) * cylinder.frame, measured);
    if (frame % 50 == 49) {
      fmt::print("  {:8.2f} s: drag {:.4f}, lift {:.4f}\n", wake.times.back(), wake.drag.back(),
                 wake.lift.back());
      std::fflush(stdout);
    }
  }
  fmt::print("  {:.2f} cycles a projection, divergence {:.2g}\n", measured[7], measured[0]);
  return wake;
}

struct WakeBars {
  Range strouhal, drag, lift;
};

bool cylinder(int cells, double seconds, const WakeBars& bars) {
  fmt::print("cylinder 2D-2, {} cells a diameter, {} s\n", cells, seconds);
  const flows::Wake wake = wakeOf(flows::schaeferTurek(cells), seconds);
  bool fine = within("Strouhal", wake.frequency(2) * 0.1, bars.strouhal);
  fine = within("largest drag", wake.maxDrag(2), bars.drag) && fine;
  return within("largest lift", wake.maxLift(2), bars.lift) && fine;
}

bool wide(int cells, double seconds, Range strouhal) {
  fmt::print("cylinder, Re 100, blockage 1/30, {} cells a diameter, {} diameters' time\n", cells, seconds);
  const flows::Wake wake = wakeOf(flows::wideChannel(cells), seconds);
  fmt::print("  drag {:.4f}, largest lift {:.4f}\n", wake.meanDrag(30), wake.maxLift(30));
  return within("Strouhal", wake.frequency(40), strouhal);
}

using Advection = sim::FluidParameters::Advection;

bool cavity(int cells, double reynolds, Advection advection, double turns) {
  constexpr double frame = 0.25;
  fmt::print("cavity {}x{}, Re {}, {} turns of the lid, advection {}\n", cells, cells, reynolds, turns,
             advection == Advection::cubic ? "cubic" : "macCormack");
  auto parameters = flows::cavity(cells, reynolds);
  parameters.advection = advection;
  const auto fluid = fluidOf(parameters, frame);
  for (int i = 0; i * frame < turns; ++i) fluid->pass(i * frame);
  const auto flow = fluid->state()[0].readAll<glm::vec4>();
  bool fine = within("from Ghia et al.", flows::ghiaError(flows::ghia(reynolds), cells, flow), {0, 0.02});
  if (reynolds != 1000) return fine;
  const flows::Extremes got = flows::extremesOf(cells, flow), want = flows::botellaPeyret;
  const double share = cells >= 256 ? 0.005 : 0.05;
  const auto near = [&](const char* extreme, double value, double table) {
    const double off = std::abs(table) * share;
    fine = within(extreme, value, {table - off, table + off}) && fine;
  };
  near("least u", got.u, want.u);
  near("greatest v", got.maximum, want.maximum);
  near("least v", got.minimum, want.minimum);
  return fine;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  const auto number = [&](int i, double standard) { return argc > i ? std::atof(argv[i]) : standard; };
  const bool speed = what == "speed" || what == "water";
  if (!speed && what != "cylinder" && what != "wide" && what != "cavity" && what != "quick") {
    fmt::print(stderr,
               "usage: bench_fluid cylinder|wide|cavity|quick [CELLS [SECONDS|RE [macCormack]]]\n"
               "       bench_fluid speed|water [SIDE [CYCLES [PATH]]]\n");
    return 2;
  }
  const gl::Context context({.device = "", .memoryPath = speed && argc > 4 ? argv[4] : ""});
  fmt::print("device: {}\n", context.device().name);
  const WakeBars published{{0.295, 0.305}, {3.23 * 0.97, 3.23 * 1.03}, {0.9, 1.1}};
  if (speed) {
    const bool fluid = what == "speed", software = gl::softwareDriver();
    const auto side =
        static_cast<int>(number(2, fluid ? (software ? 512 : 4096) : (software ? 1024 : 8192)));
    if (fluid)
      bench::printFluidSpeed(side, static_cast<int>(number(3, 0)));
    else
      bench::printWaterSpeed(side);
    return 0;
  }
  bool fine = true;
  if (what == "cylinder") fine = cylinder(static_cast<int>(number(2, 40)), number(3, 8), published);
  if (what == "wide") fine = wide(static_cast<int>(number(2, 12)), number(3, 160), {0.16, 0.17});
  if (what == "cavity") {
    const double reynolds = number(3, 1000);
    const Advection advection =
        argc > 4 && std::string_view(argv[4]) == "macCormack" ? Advection::macCormack : Advection::cubic;
    fine = cavity(static_cast<int>(number(2, 128)), reynolds, advection,
                  reynolds < 200   ? 15
                  : reynolds < 500 ? 30
                                   : 45);
  }
  if (what == "quick") {
    fine = cylinder(10, 3.2, {{0.27, 0.32}, {2.7, 3.75}, {0.9, 1.3}});
    fine = cavity(32, 100, Advection::macCormack, 15) && fine;
  }
  return fine ? 0 : 1;
}
