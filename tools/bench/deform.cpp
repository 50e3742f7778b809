// Compares the five deformation techniques on a 401x401 grid with the simulation "ripple". Prints the
// milliseconds from the start of a frame's deformation to the start of drawing, and of the stages of that
// time. The technique "compute" also runs with readback. The machine should be idle.
#include "gl/context.hpp"
#include "sim/mesh/parameters.hpp"
#include "sim/world/list.hpp"

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include <fmt/format.h>

using namespace simreel;

namespace {

double median(std::vector<double>& values) {
  if (values.empty()) return 0;
  std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// Prints a row of the table. Returns the median milliseconds of a frame.
double measure(const char* name, sim::DeformTechnique technique, bool readback, int frames) {
  scene::Object object;
  object.name = "sheet";
  auto parameters = std::make_unique<sim::MeshParameters>();
  parameters->size = {20, 0, 20};
  parameters->resolution = {401, 401};
  parameters->deform.list.resize(1);
  parameters->deform.list[0].ripple.on = true;
  parameters->deform.technique = technique;
  parameters->deform.readback = readback;
  object.parameters = std::move(parameters);
  const std::vector<sim::ColliderShape> none;
  const sim::SimulationKind* mesh = nullptr;
  for (const sim::SimulationKind& kind : sim::simulations())
    if (std::string(kind.kind.name) == "mesh") mesh = &kind;
  sim::Setting setting{false, 1, 1.0 / 60.0, &none};
  setting.timing = true;
  const auto sheet = mesh->make(object, setting);
  std::vector<double> whole;
  std::vector<double> stages[3];
  constexpr int warmUp = 10;
  for (int frame = 0; frame < frames + warmUp; ++frame) {
    const auto start = std::chrono::steady_clock::now();
    sheet->step(frame / 60.0, {});
    glFinish();
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    if (frame < warmUp) continue;
    whole.push_back(took.count());
    const auto times = sheet->stageTimes();
    for (std::size_t i = 0; i < times.size(); ++i) stages[i].push_back(times[i].second);
  }
  const double milliseconds = median(whole);
  fmt::print("{:<20} {:>9.3f} {:>9.3f} {:>9.3f} {:>9.3f}\n", name, milliseconds, median(stages[0]),
             median(stages[1]), median(stages[2]));
  return milliseconds;
}

}  // namespace

int main(int argc, char** argv) {
  const int frames = argc > 1 ? std::stoi(argv[1]) : 100;
  const gl::Context context;
  fmt::print("device: {}; 160,801 vertices, median of {} frames, ms\n", context.device().name, frames);
  fmt::print("{:<20} {:>9} {:>9} {:>9} {:>9}\n", "technique", "frame", "deform", "normals", "transfer");
  using T = sim::DeformTechnique;
  const double single = measure("single-thread", T::singleThread, false, frames);
  const double jobs = measure("jobs", T::jobs, false, frames);
  const double mapped = measure("mapped", T::mapped, false, frames);
  const double compute = measure("compute", T::compute, false, frames);
  const double copied = measure("compute + readback", T::compute, true, frames);
  measure("vertex-shader", T::vertexShader, false, frames);
  fmt::print(
      "jobs are {:.2f} times as fast as single-thread, mapped {:.2f}; readback takes {:.2f} of compute's "
      "time\n",
      single / jobs, single / mapped, copied / compute);
}
