// Measures gravity between all pairs of bodies. Compares the device in exact and in fast mode with plain
// loops on the CPU, and with a plain CUDA kernel if particles/pairs.cu is built in (nvcc was found). Prints
// interactions/s, the best of several runs, where an interaction is the attraction of one body by another.
// Then measures particles without mutual attraction, in particle-steps/s.
//
//     bench_particles [bodies] [free particles]
#include "sim/particles/particles.hpp"

#include "base/processor.hpp"
#include "gl/context.hpp"
#include "plain/plain.hpp"
#include "reference/particles_twin.hpp"
#include "sim/core/shader_code.hpp"
#include "sim/particles/pairs.hpp"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>

using namespace simreel;

/// Function of particles/soa.cpp, which the compiler vectorises for this machine. Writes three floats per
/// target to `sums`.
void soaPairs(const float* x, const float* y, const float* z, const float* mass, int count, int first,
              int end, float softening, float* sums);

/// Function of particles/native.cpp: the plain loop, compiled for this machine's instruction set. Each body
/// has four floats, xyzw.
void nativePairs(const float* bodies, float* accelerations, int count, int first, int end, float gravity,
                 float softening);

#ifdef SIMREEL_BENCH_CUDA
/// Function of particles/pairs.cu. Returns the seconds of the fastest of `runs` runs, or a negative number
/// if there is no CUDA device. Writes four floats, xyzw, per body to `accelerations`.
double cudaPairs(const float* bodies, float* accelerations, int count, float gravity, float softening,
                 int runs);
#endif

namespace {

constexpr float gravity = 0.01F;
constexpr float softening = 0.1F;

std::vector<glm::vec4> cloud(int count) {
  std::vector<glm::vec4> bodies;
  for (unsigned i = 0; i < static_cast<unsigned>(count); ++i) {
    const auto bits = shader::hash3({i, 1, 2});
    bodies.emplace_back(shader::signedUnit(bits.x), shader::signedUnit(bits.y), shader::signedUnit(bits.z),
                        1.0F / static_cast<float>(count));
  }
  return bodies;
}

/// Shortest processor time of a run in the latest call of best(), summed over all threads. Unlike
/// wall-clock time, it excludes other load on the machine.
double processorSeconds = 0;

/// Returns the seconds of the fastest run. Runs `body` at least three times and for half a second.
double best(const std::function<void()>& body) {
  double shortest = 1e300;
  processorSeconds = 1e300;
  double total = 0;
  for (int run = 0; run < 3 || total < 0.5; ++run) {
    const auto begin = std::chrono::steady_clock::now();
    const std::clock_t clock = std::clock();
    body();
    processorSeconds =
        std::min(processorSeconds, static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    shortest = std::min(shortest, seconds);
    total += seconds;
  }
  return shortest;
}

/// Bodies as a structure of arrays, with one array per coordinate.
struct Soa {
  std::vector<float> x, y, z, mass;
  explicit Soa(const std::vector<glm::vec4>& bodies) {
    for (const glm::vec4& b : bodies) {
      x.push_back(b.x);
      y.push_back(b.y);
      z.push_back(b.z);
      mass.push_back(b.w);
    }
  }
};

/// Distributes the targets 0 to count-1 over threads.
void shared(int count, unsigned threads, const std::function<void(int, int)>& part) {
  const auto bound = [&](unsigned i) {
    return static_cast<int>(static_cast<long long>(count) * i / threads);
  };
  std::vector<std::thread> others;
  for (unsigned t = 1; t < threads; ++t) others.emplace_back(part, bound(t), bound(t + 1));
  part(0, bound(1));
  for (std::thread& thread : others) thread.join();
}

void nativeLoop(const std::vector<glm::vec4>& bodies, std::vector<glm::vec4>& out, unsigned threads) {
  const auto count = static_cast<int>(out.size());
  shared(count, threads, [&](int first, int end) {
    nativePairs(&bodies[0].x, &out[0].x, count, first, end, gravity, softening);
  });
}

void soaLoop(const Soa& bodies, std::vector<glm::vec4>& out, unsigned threads) {
  std::vector<float> sums(out.size() * 3);
  const auto count = static_cast<int>(out.size());
  shared(count, threads, [&](int first, int end) {
    soaPairs(bodies.x.data(), bodies.y.data(), bodies.z.data(), bodies.mass.data(), count, first, end,
             softening, sums.data());
  });
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = glm::vec4(sums[i * 3], sums[i * 3 + 1], sums[i * 3 + 2], 0) * gravity;
}

/// Returns reference accelerations, summed in double precision. The error of each implementation is
/// measured against them.
std::vector<glm::vec4> exactSums(const std::vector<glm::vec4>& bodies, std::size_t targets) {
  std::vector<glm::vec4> out;
  for (std::size_t i = 0; i < targets; ++i) {
    glm::dvec3 sum(0);
    for (const glm::vec4& body : bodies) {
      const glm::dvec3 d = glm::dvec3(body) - glm::dvec3(bodies[i]);
      const double squared = d.x * d.x + d.y * d.y + d.z * d.z + static_cast<double>(softening) * softening;
      sum += d * (static_cast<double>(body.w) / (squared * std::sqrt(squared)));
    }
    out.emplace_back(glm::vec3(sum * static_cast<double>(gravity)), 0.0F);
  }
  return out;
}

/// Returns the maximum difference of accelerations relative to the maximum acceleration. It shows that all
/// implementations solve the same problem.
double difference(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
  float max = 0;
  float scale = 0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    for (int c = 0; c < 3; ++c) {
      max = std::max(max, std::abs(a[i][c] - b[i][c]));
      scale = std::max(scale, std::abs(a[i][c]));
    }
  return max / scale;
}

void pairs(int count) {
  const auto bodies = cloud(count);
  const auto truth = exactSums(bodies, std::min<std::size_t>(bodies.size(), 1024));
  std::vector<glm::vec4> out(bodies.size());
  const double interactions = static_cast<double>(count) * count;
  double plainSeconds = 0;
  double twoSeconds = 0;
  const auto line = [&](const char* what, double seconds) {
    fmt::print("{:30} {:9.3f} ms {:9.3e} interactions/s ({:9.3e} a processor second)", what, seconds * 1e3,
               interactions / seconds, interactions / std::max(processorSeconds, 1e-9));
    if (plainSeconds > 0)
      fmt::print(" {:8.2f}x plain {:8.2f}x two threads", plainSeconds / seconds, twoSeconds / seconds);
    fmt::print("  off by {:.1e}\n", difference(truth, out));
  };
  fmt::print("all pairs, {} bodies\n", count);
  const Soa soa(bodies);
  if (count <= 32768) {
    twoSeconds = best([&] { nativeLoop(bodies, out, 2); });
    std::vector<plain::Body> own;
    for (const glm::vec4& b : bodies) own.push_back({b.x, b.y, b.z, b.w});
    std::vector<plain::Vec3> sums(own.size());
    plainSeconds = best([&] { plain::pairs(own, sums, gravity, softening); });
    std::transform(sums.begin(), sums.end(), out.begin(),
                   [](const plain::Vec3& a) { return glm::vec4(a.x, a.y, a.z, 0); });
    line("plain loop, one thread", plainSeconds);
    line("-march=native, two threads", best([&] { nativeLoop(bodies, out, 2); }));
    line("vectorised, one thread", best([&] { soaLoop(soa, out, 1); }));
    line("vectorised, two threads", best([&] { soaLoop(soa, out, 2); }));
  }
  const auto all = static_cast<unsigned>(processorCount());
  if (all > 2) line("vectorised, all threads", best([&] { soaLoop(soa, out, all); }));
  const gl::Vec4Array positions("bodies", bodies);
  const gl::Vec4Array accelerations("accelerations", out);
  for (const bool fast : {false, true}) {
    sim::PairGravity kernel(fast);
    const auto run = [&] {
      kernel.accelerate(positions, accelerations, count, gravity, softening);
      glFinish();
    };
    run();
    const double seconds = best(run);
    out = accelerations.buffer().readAll<glm::vec4>();
    line(fast ? "device, fast" : "device, exact", seconds);
  }
#ifdef SIMREEL_BENCH_CUDA
  const double seconds = cudaPairs(&bodies[0].x, &out[0].x, count, gravity, softening, 10);
  if (seconds > 0) line("CUDA, shared tile", seconds);
#endif
}

void freeParticles(int count, bool turbulence) {
  sim::ParticleParameters p;
  p.method = sim::GravityMethod::none;
  p.groups.emplace_back().count = count;
  p.groups[0].totalMass = 1000;
  p.attractor.emplace();
  p.turbulence.strength = turbulence ? 1.0F : 0.0F;
  p.substeps = 8;
  scene::Object object;
  object.name = "cloud";
  object.parameters = std::make_unique<sim::ParticleParameters>(p);
  const std::vector<sim::ColliderShape> colliders;
  for (const bool fast : {false, true}) {
    const auto particles = sim::particlesKind().make(object, {fast, 1, 1.0 / 60, &colliders});
    particles->step(0, {});
    glFinish();
    const double seconds = best([&] {
      particles->step(0, {});
      glFinish();
    });
    fmt::print("{} free particles, attractor{}, {}: {:.3f} ms a substep, {:.3e} particle-steps/s\n", count,
               turbulence ? " and turbulence" : "", fast ? "fast" : "exact", seconds / 8 * 1e3,
               8.0 * count / seconds);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const gl::Context context;
  fmt::print("device: {}; {} processors\n", context.device().name, processorCount());
  pairs(argc > 1 ? std::atoi(argv[1]) : 8192);
  const int count = argc > 2 ? std::atoi(argv[2]) : 1000000;
  if (count > 0) {
    freeParticles(count, false);
    freeParticles(count, true);
  }
}
