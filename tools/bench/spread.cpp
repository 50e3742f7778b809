// Measures cells per second of an endless epidemic and of a growing wildfire, on the device and on the CPU
// twin with one thread and with all threads. All compute the same steps from the same initial state.
#include "base/clock.hpp"
#include "gl/context.hpp"
#include "reference/spread_twin.hpp"
#include "sim/spread/epidemic.hpp"
#include "sim/spread/wildfire.hpp"

#include <algorithm>
#include <ctime>
#include <memory>

#include <fmt/format.h>

using namespace simreel;

namespace {

constexpr double frameSeconds = 1.0 / 60;
constexpr int stepsEach = 16;

/// Returns an epidemic in which about a tenth of the cells is infected in the steady state.
sim::EpidemicParameters city(int side) {
  sim::EpidemicParameters p;
  p.size = {side, side};
  p.border = sim::SpreadParameters::Border::torus;
  p.stepsPerSecond = 60 * stepsEach;
  p.infected = 0.1;
  p.immune = 0.5;
  p.beta = 0.05F;
  p.gamma = 0.1F;
  p.waning = 0.02F;
  return p;
}

/// Returns a forest with a hundred fires.
sim::WildfireParameters forest(int side) {
  sim::WildfireParameters p;
  p.size = {side, side};
  p.border = sim::SpreadParameters::Border::torus;
  p.stepsPerSecond = 60 * stepsEach;
  p.windStrength = 0.5F;
  for (int i = 0; i < 100; ++i) {
    sim::StrokeParameters spot;
    spot.from = spot.to = glm::vec3((i % 10 + 0.5F) * side / 10, (i / 10 + 0.5F) * side / 10, 0);
    p.strokes.push_back(spot);
  }
  return p;
}

/// Returns the processor seconds of all threads so far.
double processorSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Times {
  double seconds = 1e9;
  double processor = 1e9;
};

/// Runs half of the frames as a warm-up. Returns the shortest times of the remaining frames.
template <class Frame>
Times secondsOf(int frames, const Frame& frame) {
  Times best;
  for (int i = 0; i < frames; ++i) {
    const auto begin = Clock::now();
    const double before = processorSeconds();
    frame(i * frameSeconds);
    if (i < frames / 2) continue;
    best.seconds = std::min(best.seconds, secondsSince(begin));
    best.processor = std::min(best.processor, processorSeconds() - before);
  }
  return best;
}

template <class Parameters>
std::unique_ptr<sim::Simulation> onDevice(const sim::SimulationKind& kind, const Parameters& parameters) {
  scene::Object object;
  object.name = "field";
  object.parameters = std::make_unique<Parameters>(parameters);
  static const std::vector<sim::ColliderShape> none;
  return kind.make(object, {false, 1, frameSeconds, &none});
}

void line(const char* what, int side, const Times& times) {
  const double cells = static_cast<double>(side) * side * stepsEach;
  fmt::print("{:34} {:6}x{:<6} {:10.3f} ms a step {:10.3e} cells/s {:10.3e} a processor second\n", what,
             side, side, times.seconds / stepsEach * 1e3, cells / times.seconds,
             cells / std::max(times.processor, 1e-9));
}

template <class Parameters>
void device(const char* name, const sim::SimulationKind& kind, const Parameters& parameters, int frames) {
  const std::unique_ptr<sim::Simulation> simulation = onDevice(kind, parameters);
  if (!gl::softwareDriver()) {  // This loop is a warm-up, because an idle GPU starts at a sixth of its
                                // clock rate.
    const std::unique_ptr<sim::Simulation> other = onDevice(kind, parameters);
    const auto start = Clock::now();
    for (int i = 0; secondsSince(start) < 0.5; ++i) {
      other->step(i * frameSeconds, {});
      glFinish();
    }
  }
  line(name, parameters.size.x, secondsOf(frames, [&](double time) {
         simulation->step(time, {});
         glFinish();
       }));
  const auto rows = simulation->counts().steps->readAll<glm::uvec4>();
  fmt::print("  of a thousand cells {:.0f} spread\n",
             1e3 * rows[0].y / parameters.size.x / parameters.size.y);
}

}  // namespace

int main() {
  const gl::Context context;
  fmt::print("device: {}\n", context.device().name);
  for (const int side : {1024, 8192}) {
    if (context.device().software && side > 1024) continue;
    const int frames = 10;
    if (side <= 1024) {
      for (const int threads : {1, 0}) {
        EpidemicTwin people(sim::EpidemicPlan(city(side), "city", 1, frameSeconds));
        line(threads == 1 ? "epidemic, twin, one thread" : "epidemic, twin, all threads", side,
             secondsOf(frames, [&](double t) { people.step(t, threads); }));
        WildfireTwin fire(sim::WildfirePlan(forest(side), "forest", 1, frameSeconds));
        line(threads == 1 ? "wildfire, twin, one thread" : "wildfire, twin, all threads", side,
             secondsOf(frames, [&](double t) { fire.step(t, threads); }));
      }
    }
    device("epidemic, device", sim::epidemicKind(), city(side), frames);
    device("wildfire, device", sim::wildfireKind(), forest(side), frames);
  }
}
