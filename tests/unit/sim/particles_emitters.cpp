// Tests emitted particles by comparison with closed forms and with their equation of motion, which is
// solved independently in double precision. Births occur at any moment of a step.
#include "reference/particles_twin.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;
using glm::dvec3;

namespace {

/// Returns a jet without spread, with `rate` births per second. No particle dies within 9 s.
sim::ParticleParameters jet(double rate) {
  sim::ParticleParameters p;
  p.method = sim::GravityMethod::none;
  auto& emitter = p.emitters.emplace_back();
  emitter.rate = static_cast<float>(rate);
  emitter.spread = 0;
  emitter.speedVariation = 0;
  emitter.lifetime = 9;
  emitter.lifetimeVariation = 0;
  emitter.mass = 1e-9F;
  emitter.velocity = glm::vec3(3, 6, 0);
  return p;
}

struct Emitted {
  double birth;  ///< time of birth, s
  dvec3 position, velocity;
};

/// Returns the jet after `seconds`, oldest particles first. Particle n (zero-based) is born at time (n + 1)
/// / rate.
std::vector<Emitted> emitted(const sim::ParticleParameters& p, double fps, double seconds,
                             const std::function<void(ParticlesTwin&)>& prepare = {}) {
  ParticlesTwin twin(sim::ParticlePlan(p, 1, 1 / fps));
  if (prepare) prepare(twin);
  const auto frames = std::lround(seconds * fps);
  for (long frame = 0; frame < frames; ++frame) twin.step(static_cast<double>(frame) / fps);
  std::vector<Emitted> found;
  const double rate = static_cast<double>(p.emitters[0].rate);
  std::size_t groups = 0;
  for (const auto& group : p.groups) groups += static_cast<std::size_t>(group.count);
  for (std::size_t i = groups; i < twin.positions.size() && twin.velocities[i].w >= 0; ++i)
    found.push_back(
        {static_cast<double>(i - groups + 1) / rate, dvec3(twin.positions[i]), dvec3(twin.velocities[i])});
  CHECK(found.size() == static_cast<std::size_t>(seconds * rate));
  return found;
}

/// Solves x'' = a(x, t) from a birth on by the Runge-Kutta method.
Emitted solved(dvec3 position, dvec3 velocity, double birth, double end,
               const std::function<dvec3(dvec3, double)>& acceleration) {
  constexpr int steps = 2000;
  const double h = (end - birth) / steps;
  for (int i = 0; i < steps; ++i) {
    const double t = birth + i * h;
    const dvec3 a1 = acceleration(position, t);
    const dvec3 v2 = velocity + a1 * (h / 2);
    const dvec3 a2 = acceleration(position + velocity * (h / 2), t + h / 2);
    const dvec3 v3 = velocity + a2 * (h / 2);
    const dvec3 a3 = acceleration(position + v2 * (h / 2), t + h / 2);
    const dvec3 v4 = velocity + a3 * h;
    const dvec3 a4 = acceleration(position + v3 * h, t + h);
    position += (velocity + v2 * 2.0 + v3 * 2.0 + v4) * (h / 6);
    velocity += (a1 + a2 * 2.0 + a3 * 2.0 + a4) * (h / 6);
  }
  return {birth, position, velocity};
}

/// Maximum differences between the jet at 1 s and its equation of motion.
struct Errors {
  double position = 0, velocity = 0;
};

Errors errors(const sim::ParticleParameters& p, double fps,
              const std::function<dvec3(dvec3, double)>& acceleration,
              const std::function<void(ParticlesTwin&)>& prepare = {}) {
  Errors worst;
  for (const Emitted& particle : emitted(p, fps, 1, prepare)) {
    const Emitted expected =
        solved(dvec3(p.emitters[0].position.at(particle.birth)),
               dvec3(p.emitters[0].velocity.at(particle.birth)), particle.birth, 1, acceleration);
    worst.position = std::max(worst.position, glm::length(particle.position - expected.position));
    worst.velocity = std::max(worst.velocity, glm::length(particle.velocity - expected.velocity));
  }
  return worst;
}

/// Checks that both errors are small, and that they fall to a quarter when the step is halved.
void checkSecondOrder(const sim::ParticleParameters& p, double max,
                      const std::function<dvec3(dvec3, double)>& acceleration,
                      const std::function<void(ParticlesTwin&)>& prepare = {}) {
  const Errors coarse = errors(p, 60, acceleration, prepare);
  const Errors fine = errors(p, 120, acceleration, prepare);
  CAPTURE(coarse.position);
  CAPTURE(coarse.velocity);
  CHECK(coarse.position < max);
  CHECK(coarse.velocity < max);
  CHECK(coarse.position / fine.position == doctest::Approx(4).epsilon(0.25));
  CHECK(coarse.velocity / fine.velocity == doctest::Approx(4).epsilon(0.25));
}

/// Returns the acceleration at `here` by a Plummer body at `from`. `mass`: G M of the body.
dvec3 pull(dvec3 from, dvec3 here, double mass, double softening) {
  const dvec3 d = from - here;
  return d * (mass / std::pow(glm::dot(d, d) + softening * softening, 1.5));
}

}  // namespace

TEST_CASE("emitted particles follow the closed form of a damped fall at any step rate") {
  const dvec3 v0(3, 6, 0);
  const dvec3 a(0.4, -9.8, 0);
  for (const double damping : {0.0, 0.35, 4.85, 40.0})
    for (const double fps : {24.0, 60.0, 240.0})
      for (const int substeps : {1, 3}) {
        CAPTURE(damping);
        CAPTURE(fps);
        CAPTURE(substeps);
        auto p = jet(37.3);
        p.acceleration = glm::vec3(a);
        p.damping = static_cast<float>(damping);
        p.substeps = substeps;
        double worst = 0;
        for (const Emitted& particle : emitted(p, fps, 2)) {
          const double t = 2 - particle.birth;
          // The solution of v' = a - r v is v = v0 e^(-rt) + a (1 - e^(-rt)) / r and x = v0 s + a (t - s) /
          // r, with s = (1 - e^(-rt)) / r.
          const double r = damping;
          const double kept = std::exp(-r * t);
          const double s = r > 0 ? (1 - kept) / r : t;
          const dvec3 velocity = v0 * kept + a * s;
          const dvec3 position = v0 * s + a * (r > 0 ? (t - s) / r : t * t / 2);
          worst = std::max({worst, glm::length(particle.velocity - velocity),
                            glm::length(particle.position - position)});
        }
        CHECK(worst < 3e-4);
      }
}

TEST_CASE("a moving, rotating emitter emits from its place at each birth, with the gravity of that time") {
  const dvec3 from(-1, 0, 2);
  const dvec3 speed(2, 0.5, -1);
  const dvec3 v0(3, 6, 0);
  const dvec3 turn(-4, -1, 5);
  const dvec3 jerk(0, -9, 3);
  for (const double fps : {24.0, 60.0, 240.0}) {
    CAPTURE(fps);
    auto p = jet(101.7);
    const auto line = [](dvec3 start, dvec3 slope) {
      return scene::Animated<glm::vec3>({{0.0, glm::vec3(start)}, {4.0, glm::vec3(start + slope * 4.0)}},
                                        scene::Ease::linear);
    };
    p.emitters[0].position = line(from, speed);
    p.emitters[0].velocity = line(v0, turn);
    p.acceleration = line(dvec3(0), jerk);
    double worst = 0;
    double worstVelocity = 0;
    for (const Emitted& particle : emitted(p, fps, 2)) {
      const double t = particle.birth;
      const double lived = 2 - t;
      const dvec3 start = v0 + turn * t;
      const dvec3 velocity = start + jerk * (lived * t + lived * lived / 2);
      const dvec3 position =
          from + speed * t + start * lived + jerk * (t * lived * lived / 2 + lived * lived * lived / 6);
      worstVelocity = std::max(worstVelocity, glm::length(particle.velocity - velocity));
      worst = std::max(worst, glm::length(particle.position - position));
    }
    CHECK(worstVelocity < 1e-4);
    // Leapfrog neglects jerk * dt^3 / 6 in each step's displacement.
    CHECK(worst < glm::length(jerk) * 2 / (6 * fps * fps) + 1e-4);
  }
}

TEST_CASE("new particles near a moving attractor are as accurate as leapfrog") {
  auto p = jet(17.3);
  p.gravity = 1;
  p.attractor.emplace();
  p.attractor->mass = 12.0F;
  p.attractorSoftening = 0.5F;
  p.attractor->position = scene::Animated<glm::vec3>({{0.0, glm::vec3(0, 2, 0)}, {1.0, glm::vec3(3, 2, 1)}},
                                                     scene::Ease::linear);
  checkSecondOrder(p, 5e-3, [](dvec3 x, double t) { return pull({3 * t, 2, t}, x, 12, 0.5); });
}

TEST_CASE("new particles in turbulence are as accurate as leapfrog") {
  auto p = jet(17.3);
  p.turbulence.strength = 6;
  p.turbulence.size = 2;
  p.turbulence.speed = 1.5F;
  checkSecondOrder(p, 5e-3, [](dvec3 x, double t) {
    const dvec3 drift = dvec3(0.36, 0.48, 0.8) * (1.5 * t);
    return dvec3(curlNoiseAt(glm::vec3((x - drift) / 2.0), 1)) * 6.0;
  });
}

TEST_CASE("new particles near a heavy particle are as accurate as leapfrog") {
  auto p = jet(17.3);
  p.method = sim::GravityMethod::allPairs;
  p.gravity = 1;
  p.softening = 0.5F;
  p.groups.emplace_back().count = 1;
  p.acceleration = glm::vec3(0, -2, 0);
  checkSecondOrder(
      p, 1e-2,
      [](dvec3 x, double t) {
        return pull({2, 2 - t * t, 0.5}, x, 12, 0.5) + dvec3(0, -2, 0);  // The attractor also falls.
      },
      [](ParticlesTwin& twin) {
        twin.positions[0] = glm::vec4(2, 2, 0.5, 12);
        twin.velocities[0] = glm::vec4(0);
      });
}

TEST_CASE("a jet without spread is an evenly spaced line") {
  auto p = jet(1000);
  p.acceleration = glm::vec3(0, -9.8F, 0);
  p.damping = 0.35F;
  p.emitters[0].position =
      scene::Animated<glm::vec3>({{0.0, glm::vec3(0)}, {1.0, glm::vec3(1, 0, 2)}}, scene::Ease::smooth);
  p.turbulence.strength = 3;
  p.turbulence.size = 3;
  const auto line = emitted(p, 60, 1);
  // A step has 16 or 17 births, 5 mm apart. The step boundaries must not be visible in the distances.
  double worst = 0;
  for (std::size_t i = 2; i < line.size(); ++i) {
    const double before = glm::length(line[i - 1].position - line[i - 2].position);
    const double after = glm::length(line[i].position - line[i - 1].position);
    worst = std::max(worst, std::abs(after - before) / after);
  }
  CHECK(worst < 0.02);
}

TEST_CASE("particles that live shorter than a step die within it, and no births are owed later") {
  auto p = jet(1000);
  p.emitters[0].lifetime = 4e-3F;  // The lifetime is a quarter of a frame.
  p.emitters[0].until = 0.5F;
  ParticlesTwin twin(sim::ParticlePlan(p, 1, 1 / 60.0));
  for (int frame = 0; frame < 33; ++frame) {
    twin.step(frame / 60.0);
    const auto alive = std::count_if(twin.velocities.begin(), twin.velocities.end(),
                                     [](const glm::vec4& v) { return v.w >= 0; });
    CAPTURE(frame);
    CHECK(std::abs(static_cast<double>(alive) - (frame < 30 ? 4.0 : 0.0)) <= 1.0);
  }
}
