// Measures a step of gravity with the tree. Prints the milliseconds of each phase by timer queries, the
// times of the CPU twin on one thread and on all threads, and the error relative to a sum over all pairs in
// double precision for 512 bodies.
//
//     bench_gravity_tree [N...]     default 16384 on software drivers, 1048576 on GPUs
//
// Also counts the work of a step. The operations and bytes of the tree traversal are stated in
// src/sim/particles/gravity_tree.cpp. Sorting moves 48 bytes per body in each of 12 passes, and building
// the tree moves about 100 bytes per body.
#include "sim/particles/gravity_tree.hpp"

#include "gl/context.hpp"
#include "reference/gravity_tree_twin.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <limits>
#include <vector>

#include <fmt/format.h>

using namespace simreel;

namespace {

constexpr float gravity = 1;
constexpr float softening = 0.01F;

struct Phases {
  double sort, build, walk,
      total;  ///< times in milliseconds; total: wall-clock time of the whole step until the device has
              ///< finished
};

double milliseconds(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Measures the device time of `work` with a timer query. Uses the clock on software drivers, because their
/// queries return zero.
double deviceMilliseconds(const auto& work) {
  if (gl::softwareDriver())
    return milliseconds([&] {
      work();
      glFinish();
    });
  gl::TimerQuery timer;
  timer.begin();
  work();
  timer.end();
  return timer.nanoseconds() * 1e-6;
}

/// Returns the minimum times over several steps, after one warm-up step.
Phases measure(sim::GravityTree& tree, const gl::Vec4Array& positions, const gl::Vec4Array& accelerations,
               int count, float opening, int steps) {
  const double max = std::numeric_limits<double>::max();
  Phases min{max, max, max, max};
  for (int step = 0; step <= steps; ++step) {
    const double sort = deviceMilliseconds([&] { tree.sort(positions, count); });
    const double build = deviceMilliseconds([&] { tree.build(positions, count, opening); });
    const double walk = deviceMilliseconds([&] { tree.walk(accelerations, count, gravity, softening); });
    const double total = milliseconds([&] {
      tree.accelerate(positions, accelerations, count, gravity, softening, opening);
      glFinish();
    });
    if (step == 0) continue;
    min = {std::min(min.sort, sort), std::min(min.build, build), std::min(min.walk, walk),
           std::min(min.total, total)};
  }
  return min;
}

void printErrors(const std::vector<glm::vec4>& got, const std::vector<glm::dvec3>& exact,
                 const std::vector<int>& of) {
  const auto errors = relativeErrors(got, exact, of);
  fmt::print("    error: median {:.2e}, 99th percentile {:.2e}\n", errors[errors.size() / 2],
             errors[errors.size() * 99 / 100]);
}

void runTwin(const std::vector<glm::vec4>& bodies, float opening) {
  for (const int threads : {1, 0}) {
    GravityTreeTwin::Work work;
    const double time = milliseconds([&] {
      GravityTreeTwin twin(bodies, opening, threads);
      [[maybe_unused]] const auto accelerations = twin.accelerations(gravity, softening);
      work = twin.work;
    });
    fmt::print("    twin, {}: {:.1f} ms\n", threads == 1 ? "one thread" : "all threads", time);
    if (threads == 1) continue;
    const double groups = static_cast<double>(bodies.size()) / shader::groupBodies;
    fmt::print("    a group of {}: {:.0f} visits, {:.0f} multipoles, {:.0f} leaves\n", shader::groupBodies,
               static_cast<double>(work.visits) / groups, static_cast<double>(work.far) / groups,
               static_cast<double>(work.leaves) / groups);
  }
}

void run(Cloud cloud, const char* name, int count, bool software) {
  const auto bodies = bodiesOf(cloud, count);
  std::vector<int> of(512);
  for (std::size_t i = 0; i < of.size(); ++i)
    of[i] = static_cast<int>(static_cast<std::int64_t>(i) * count / static_cast<std::int64_t>(of.size()));
  const auto exact = allPairs(bodies, of, gravity, softening);
  const gl::Vec4Array positions("positions", bodies);
  const gl::Vec4Array accelerations("accelerations", bodies);
  for (const float opening : {0.5F, 0.7F}) {
    fmt::print("{} of {}, opening {}\n", name, count, opening);
    for (const bool fast : {false, true}) {
      sim::GravityTree tree(name, count, fast);
      const Phases p = measure(tree, positions, accelerations, count, opening, software ? 3 : 10);
      fmt::print("    device, {}: sort {:.2f}, build {:.2f}, walk {:.2f}; step {:.2f} ms by the clock\n",
                 fast ? "fast" : "exact", p.sort, p.build, p.walk, p.total);
      printErrors(accelerations.buffer().readAll<glm::vec4>(), exact, of);
    }
    runTwin(bodies, opening);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const gl::Context context;
  const bool software = context.device().software;
  fmt::print("device: {}\n", context.device().name);
  std::vector<int> counts;
  for (int i = 1; i < argc; ++i) counts.push_back(std::atoi(argv[i]));
  if (counts.empty()) counts.push_back(software ? 16384 : 1048576);
  for (const int count : counts) {
    if (count < 1) {
      fmt::print(stderr, "numbers of bodies are at least 1\n");
      return 2;
    }
    run(Cloud::plummer, "Plummer sphere", count, software);
    run(Cloud::disk, "disk", count, software);
  }
}
