// Measures balls in contact in a box: frames/s on the device, exact and fast, a plain loop of the same
// method on one thread of the CPU from the same state, and the time that the memory traffic takes at the
// device's rate of copying.
//   bench_balls [balls] [frames of settling] [--kernels]
// --kernels: prints the time of each kernel in one frame, exact and fast, by timer queries.
#include "plain/balls.hpp"

#include "base/processor.hpp"
#include "beside/dispatch_times.hpp"
#include "beside/memory.hpp"
#include "gl/context.hpp"
#include "sim/core/kind.hpp"
#include "sim/particles/particles.hpp"
#include "sim/particles/plan.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

using namespace simreel;

namespace ball_bench {

constexpr double frame = 1.0 / 60;
constexpr float radius = 0.05F, friction = 0.4F, restitution = 0.3F, bounce = 0.2F, weight = 9.81F;

/// Seconds by the clock, and of all processors; other load on the machine adds to the first only.
struct Taken {
  double seconds = 1e300, processor = 1e300;
};

/// Returns the least of `runs` runs.
Taken minimumOf(int runs, const auto& body) {
  Taken minimum;
  for (int i = 0; i < runs; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t clock = std::clock();
    body();
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
    minimum.seconds = std::min(minimum.seconds, seconds.count());
    minimum.processor =
        std::min(minimum.processor, static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC);
  }
  return minimum;
}

/// Returns a floor and four walls around a cube of balls that fill 0.3 of their space.
std::vector<sim::ColliderShape> box(float half) {
  std::vector<sim::ColliderShape> planes(5);
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const float side = i % 2 == 1 ? 1.0F : -1.0F;
    planes[i].kind = sim::ColliderShape::Kind::plane;
    planes[i].friction = friction;
    planes[i].position = glm::vec3(0);
    planes[i].rotation = glm::vec3(0);
    if (i == 0) continue;
    planes[i].position = i < 3 ? glm::vec3(side * half, 0, 0) : glm::vec3(0, 0, side * half);
    planes[i].rotation = i < 3 ? glm::vec3(0, 0, 90 * side) : glm::vec3(-90 * side, 0, 0);
  }
  return planes;
}

float halfOf(int count) {
  return 0.5F * std::cbrt(static_cast<float>(count) * 4.18879F * radius * radius * radius / 0.3F);
}

sim::ParticleParameters parametersOf(int count) {
  sim::ParticleParameters p;
  p.method = sim::GravityMethod::none;
  sim::ParticleGroup& group = p.groups.emplace_back();
  group.shape = sim::ParticleGroup::Shape::cube;
  group.count = count;
  group.totalMass = static_cast<float>(count);
  group.radius = halfOf(count) - radius;
  group.position = glm::vec3(0, halfOf(count), 0);
  p.contact.emplace();
  p.contact->radius = radius;
  p.contact->friction = friction;
  p.contact->restitution = restitution;
  p.acceleration = glm::vec3(0, -weight, 0);
  p.autoSubsteps = true;
  p.collides = true;
  p.bounce = bounce;
  p.margin = radius;
  return p;
}

/// Returns the bytes that the kernels of a substep move per ball, each array counted once per kernel and
/// lists of 12 neighbours.
double bytesOf(int impacts, int passes) {
  const double predict = 9 * 16, key = 4 * 16, sort = passes * 48.0, gather = 7 * 16, near = 4 * 16 + 48;
  const double impact = (4 * 16 + 48) + 8 * 16, iteration = 4 * 16 + 48, leave = 8 * 16 + 48;
  return predict + key + sort + gather + near + impacts * impact + shader::ballIterations * iteration +
         leave;
}

plain::BallHeap plainHeap(const sim::ParticlePlan& plan, const std::vector<sim::StateArray>& state,
                          float half) {
  std::vector<plain::Vec3> places, speeds;
  for (const glm::vec4& p : state[0].buffer->readAll<glm::vec4>()) places.push_back({p.x, p.y, p.z});
  for (const glm::vec4& v : state[1].buffer->readAll<glm::vec4>()) speeds.push_back({v.x, v.y, v.z});
  return {{radius, half, weight, friction, restitution, bounce, plan.ballImpacts(), shader::ballIterations},
          std::move(places),
          std::move(speeds)};
}

/// Prints times and the mean height, which shows that two programs solve the same problem.
void describe(const char* what, const Taken& taken, const Taken& plainTaken,
              const std::vector<plain::Vec3>& places) {
  double height = 0;
  for (const plain::Vec3& p : places) height += p.y;
  fmt::print(
      "{:24} {:9.3f} ms a frame, {:8.2f} frames/s, {:7.2f}x plain; {:9.3f} ms of processors, {:6.2f}x "
      "plain; "
      "mean height {:.4f} m\n",
      what, taken.seconds * 1e3, 1 / taken.seconds, plainTaken.seconds / taken.seconds,
      taken.processor * 1e3, plainTaken.processor / taken.processor,
      height / static_cast<double>(places.size()));
}

void run(int count, int settling, bool kernels) {
  const float half = halfOf(count);
  const auto colliders = box(half);
  const sim::ParticleParameters p = parametersOf(count);
  const sim::ParticlePlan plan(p, 1, frame, count, colliders);
  const int substeps = plan.parameters().substeps;
  const int passes = (std::bit_width(static_cast<unsigned>(plan.ballConstants().tableMask)) + 3) / 4;
  scene::Object object;
  object.name = "balls";
  object.parameters = std::make_unique<sim::ParticleParameters>(p);
  Taken plainTaken;
  for (const bool fast : {false, true}) {
    const auto particles = sim::particlesKind().make(object, {fast, 1, frame, &colliders});
    int at = 0;
    for (; at < settling; ++at) particles->step(at * frame, {});
    // The plain loop is measured after the device: a card that waits for seconds lowers its clock.
    auto start = plainHeap(plan, particles->state(), half);
    glFinish();
    const Taken taken = minimumOf(20, [&] {
      particles->step(at++ * frame, {});
      glFinish();
    });
    const auto heap = plainHeap(plan, particles->state(), half);
    decltype(bench::DispatchTimes().sums()) sums;
    if (kernels) {
      const bench::DispatchTimes times;
      particles->step(at++ * frame, {});
      sums = times.sums();
    }
    if (!fast) {
      plainTaken = minimumOf(3, [&] {
        for (int i = 0; i < substeps; ++i) start.step(static_cast<float>(plan.substepSeconds()));
      });
      describe("plain loop, one thread", plainTaken, plainTaken, start.positions);
    }
    describe(fast ? "device, fast" : "device, exact", taken, plainTaken, heap.positions);
    for (const auto& entry : sums)
      fmt::print("  {:9.3f} ms in {:4} dispatches: {}\n", entry.second.seconds * 1e3,
                 entry.second.dispatches, entry.first);
  }
  const double bytes = bytesOf(plan.ballImpacts(), passes) * count * substeps;
  const int dispatches = 6 + 3 * passes + 2 * plan.ballImpacts() + shader::ballIterations;
  fmt::print("{} substeps a frame, {} dispatches a substep; limit by bytes {:.3f} ms a frame ({:.1f} MB)\n",
             substeps, dispatches, bytes / bench::copiedBySecond() * 1e3, bytes * 1e-6);
}

}  // namespace ball_bench

int main(int argc, char** argv) {
  const gl::Context context;
  const bool kernels = std::string_view(argv[argc - 1]) == "--kernels";
  const int numbers = kernels ? argc - 1 : argc;
  fmt::print("device: {}; {} processors\n", context.device().name, processorCount());
  ball_bench::run(numbers > 1 ? std::atoi(argv[1]) : 100000, numbers > 2 ? std::atoi(argv[2]) : 60,
                  kernels);
}
