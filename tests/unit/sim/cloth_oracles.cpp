// Tests cloth by comparison with closed forms of mechanics: catenaries, pendulums, and falls in air. Uses
// the CPU twins, which equal the GPU bit for bit.
#include "reference/cloth_twin.hpp"
#include "reference/garment_twin.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace simreel;

namespace {

constexpr double oracleFrame = 1.0 / 60;
constexpr double oraclePi = 3.14159265358979;

/// Returns a sheet without wind, damping or pins.
sim::ClothParameters oracleSheet(int width, int height, float spacing) {
  sim::ClothParameters p;
  p.size = {width, height};
  p.spacing = spacing;
  p.wind = glm::vec3(0);
  p.damping = 0;
  p.pins.clear();
  return p;
}

ClothTwin oracleTwin(const sim::ClothParameters& p) {
  return ClothTwin(sim::ClothPlan(p, 1, oracleFrame, {}));
}

/// Elastic catenary (Irvine, Cable Structures, 1981): x = a (asinh(s / a) + c s) and y = a (sqrt(1 + (s /
/// a)^2) - 1) + c s^2 / 2. s is the rest length from the lowest point, a = H / w with the horizontal
/// tension H and the weight per length w, and c = w / (E A) with the axial stiffness E A.
struct Catenary {
  double a = 0, c = 0;
  Catenary(double halfLength, double halfSpan, double weightPerStiffness) : c(weightPerStiffness) {
    double low = 1e-3;
    double high = 1e3;
    for (int i = 0; i < 100; ++i) {
      a = 0.5 * (low + high);
      (at(halfLength).x < halfSpan ? low : high) = a;
    }
  }
  [[nodiscard]] glm::dvec3 at(double s) const {
    return {a * (std::asinh(s / a) + c * s), a * (std::sqrt(1 + s * s / (a * a)) - 1) + 0.5 * c * s * s, 0};
  }
};

/// Hangs two parallel rows of 40 links of 0.1 m between supports 3 m apart, and simulates until they are at
/// rest. Returns the maximum distance of a particle from the catenary (m).
double distanceFromCatenary(sim::ClothParameters p, double weightPerStiffness) {
  constexpr int links = 40;
  p.damping = 3;
  // With many substeps, rounding must not stop the motion too early.
  p.substeps = !p.constrained() ? 32 : p.compliance > 0 ? 8 : 64;
  p.pins.emplace_back().columns = {0};
  p.pins.emplace_back().columns = {-1};
  p.pins[0].move = glm::vec3(0.5F, 0, 0);
  p.pins[1].move = glm::vec3(-0.5F, 0, 0);
  ClothTwin twin = oracleTwin(p);
  for (auto& position : twin.positions) position.x *= 0.75F;
  for (int frame = 0; frame < 900; ++frame) twin.step(frame * oracleFrame);
  const Catenary catenary(2, 1.5, weightPerStiffness);
  const double depth = catenary.at(2).y;
  double farthest = 0;
  for (int i = 0; i <= links; ++i) {
    const double s = 0.1 * i - 2;
    glm::dvec3 there = catenary.at(std::abs(s));
    there = {s < 0 ? -there.x : there.x, there.y - depth, -0.05};
    farthest =
        std::max(farthest, glm::length(glm::dvec3(twin.positions[static_cast<std::size_t>(i)]) - there));
  }
  return farthest;
}

}  // namespace

TEST_CASE("oracle: springs hang in the elastic catenary within 4 mm") {
  for (const double stiffness : {500.0, 5000.0}) {
    CAPTURE(stiffness);
    sim::ClothParameters p = oracleSheet(41, 2, 0.1F);
    p.mass = 0.05F;
    p.stiffness = static_cast<float>(stiffness);
    p.shear = 0;
    p.bend = 0;
    // For a link of 0.1 m, E A = 0.1 k. The weight per metre is 10 m g.
    const double distance = distanceFromCatenary(p, 0.05 * 9.8 / 0.1 / (0.1 * stiffness));
    CHECK(distance < 0.004);
  }
}

TEST_CASE("oracle: constraints hang in the catenary within 2 mm, compliant ones in the elastic catenary") {
  for (const double compliance : {0.0, 2e-3}) {
    CAPTURE(compliance);
    sim::ClothParameters p = oracleSheet(41, 2, 0.1F);
    p.mass = 0.05F;
    p.solver = sim::ClothSolver::constraints;
    p.compliance = static_cast<float>(compliance);
    p.shearCompliance = 1e5F;
    p.bendCompliance = 1e5F;
    CHECK(distanceFromCatenary(p, 0.05 * 9.8 / 0.1 / 0.1 * compliance) < 0.002);
  }
}

namespace {

/// Returns the period of a pendulum, T = 4 sqrt(L / g) K(sin(amplitude / 2)), with K = pi / (2 agm(1,
/// cos(amplitude / 2))) and the arithmetic-geometric mean agm.
double pendulumPeriod(double length, double amplitude) {
  double a = 1;
  double b = std::cos(0.5 * amplitude);
  for (int i = 0; i < 30; ++i) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return 4 * std::sqrt(length / 9.8) * oraclePi / (2 * a);
}

/// Times at which a series crosses zero upwards, and the maximum between each two successive crossings.
struct Crossings {
  std::vector<double> times, peaks;
  double before = 0, peak = 0;
  void see(double value, double time, double step) {
    peak = std::max(peak, value);
    if (before < 0 && value >= 0) {
      times.push_back(time - step * value / (value - before));
      peaks.push_back(peak);
      peak = 0;
    }
    before = value;
  }
};

}  // namespace

TEST_CASE("oracle: a pendulum's period equals the elliptic integral at any amplitude") {
  for (const int kind : {0, 1, 2})  // `kind` selects springs, energy-conserving constraints, or constraints
                                    // of damped cloth.
    for (const double degrees : {10.0, 60.0, 120.0}) {
      CAPTURE(degrees);
      CAPTURE(kind);
      // Two masses are side by side, 1 m below two pins.
      sim::ClothParameters p = oracleSheet(2, 2, 1);
      p.solver = kind > 0 ? sim::ClothSolver::constraints : sim::ClothSolver::springs;
      if (kind == 2) p.damping = 1e-6F;
      p.stiffness = 2e5F;
      p.shear = 0;
      p.bend = 0;
      p.shearCompliance = 1e6F;
      p.bendCompliance = 1e6F;
      const int substeps = p.constrained() ? 16 : 128;
      p.substeps = substeps;
      p.rotation = glm::vec3(static_cast<float>(90 - degrees), 0, 0);
      p.pins.emplace_back().rows = {0};
      ClothTwin twin = oracleTwin(p);
      const double step = oracleFrame / substeps;
      Crossings crossings;
      long substep = 0;
      for (int frame = 0; frame < 720; ++frame)
        for (const auto& data : twin.plan().frame(frame * oracleFrame)) {
          twin.substep(data);
          const glm::dvec3 hangs = glm::dvec3(twin.positions[2]) - glm::dvec3(twin.positions[0]);
          crossings.see(std::atan2(hangs.z, -hangs.y), static_cast<double>(++substep) * step, step);
        }
      REQUIRE(crossings.times.size() > 3);
      const double bar = p.constrained() ? 2e-3 : 5e-4;
      for (std::size_t i = 1; i < crossings.times.size(); ++i) {
        const double period = crossings.times[i] - crossings.times[i - 1];
        const double amplitude = crossings.peaks[i];
        CHECK(std::abs(period / pendulumPeriod(1, amplitude) - 1) < bar);
      }
      CHECK(crossings.peaks[1] > 0.99 * degrees * oraclePi / 180);
    }
}

TEST_CASE(
    "oracle: a hanging sheet swings like a chain, with half the first zero of J0 times sqrt(g / L) as "
    "angular frequency") {
  for (const bool damped : {false, true}) {
    CAPTURE(damped);
    sim::ClothParameters p = oracleSheet(5, 41, 0.025F);
    if (damped) p.damping = 1e-6F;
    p.fabric.emplace();
    p.substeps = 16;
    p.rotation = glm::vec3(88, 0, 0);
    p.pins.emplace_back().rows = {0};
    ClothTwin twin = oracleTwin(p);
    // To first order in the amplitude, the mode's shape is J0(2 w sqrt(s / g)), where s is the distance
    // from the free end.
    const double w = 0.5 * 2.404825557695773 * std::sqrt(9.8);
    for (int y = 0; y < 41; ++y)
      for (int x = 0; x < 5; ++x) {
        glm::vec4& at = twin.positions[static_cast<std::size_t>(5 * y + x)];
        const double s = 1 - 0.025 * y;
        at.y = static_cast<float>(0.5 * std::cos(2 / 57.29577951308232) - 0.025 * y);
        at.z = twin.positions[static_cast<std::size_t>(x)].z +
               static_cast<float>(0.02 * std::cyl_bessel_j(0, 2 * w * std::sqrt(s / 9.8)));
      }
    const double step = oracleFrame / 16;
    Crossings crossings;
    long substep = 0;
    for (int frame = 0; frame < 480; ++frame)
      for (const auto& data : twin.plan().frame(frame * oracleFrame)) {
        twin.substep(data);
        crossings.see(twin.positions[202].z - twin.positions[2].z, static_cast<double>(++substep) * step,
                      step);
      }
    REQUIRE(crossings.times.size() > 3);
    const double period = (crossings.times.back() - crossings.times.front()) /
                          static_cast<double>(crossings.times.size() - 1);
    CHECK(std::abs(period * w / (2 * oraclePi) - 1) < 2e-3);
  }
}

namespace {

/// Returns the maximum deviation from v = v1 tanh(g t / v1) during 1.5 s, relative to the terminal speed
/// v1.
template <class Twin>
double missesFall(Twin twin, double terminal) {
  double maximum = 0;
  for (int frame = 0; frame < 90; ++frame) {
    twin.step(frame * oracleFrame);
    const double expected = terminal * std::tanh(9.8 * (frame + 1) * oracleFrame / terminal);
    for (const glm::vec4& v : twin.velocities)
      maximum = std::max(maximum, std::abs(-static_cast<double>(v.y) - expected) / terminal);
  }
  return maximum;
}

}  // namespace

TEST_CASE("oracle: flat cloth falls through air at its terminal velocity") {
  const auto terminalOf = [](double density) { return std::sqrt(2 * density * 9.8 / (1.2 * 0.9)); };
  sim::ClothParameters p = oracleSheet(2, 2, 0.1F);
  p.air.emplace();
  p.air->velocity = glm::vec3(0);
  p.air->drag = 0.9F;
  p.air->gusts = 0;
  // With springs, each of four masses has a quarter of a square's area.
  p.mass = 0.00025F;
  p.stiffness = 1;
  p.substeps = 32;
  CHECK(missesFall(oracleTwin(p), terminalOf(0.1)) < 2e-3);
  for (const auto material : {sim::FabricMaterial::silk, sim::FabricMaterial::canvas}) {
    p.size = {9, 7};
    p.spacing = 0.05F;
    p.fabric.emplace();
    p.mesh.reset();
    p.fabric->material = material;
    p.substeps = 8;
    const double terminal = terminalOf(p.fabric->constants().density);
    CAPTURE(terminal);
    CHECK(missesFall(oracleTwin(p), terminal) < 0.01);
    p.mesh.emplace();
    p.mesh->size = glm::vec3(0.4F, 0, 0.3F);
    p.mesh->resolution = {9, 7};
    CHECK(missesFall(GarmentTwin(sim::GarmentPlan("cloth", p, 1, oracleFrame, {})), terminal) < 0.01);
  }
}
