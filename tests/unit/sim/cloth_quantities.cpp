#include "measured.hpp"
#include "sim/cloth/quantities.hpp"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

using namespace simreel;

namespace {

/// Returns 3x3 particles 0.5 m apart in the xy plane, with x scaled.
std::vector<glm::vec4> sheet(float scale) {
  std::vector<glm::vec4> positions;
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 3; ++x)
      positions.emplace_back(0.5F * scale * static_cast<float>(x), 0.5F * static_cast<float>(y), 0, 1);
  return positions;
}

sim::ClothParameters parameters() {
  sim::ClothParameters p;
  p.size = {3, 3};
  p.spacing = 0.5F;
  p.mass = 2;
  p.stiffness = 16;
  p.shear = 0.5F;
  p.bend = 0.25F;
  return p;
}

const std::vector<glm::vec4> still(9, glm::vec4(0));

}  // namespace

TEST_CASE("a cloth at rest has the expected quantities") {
  const auto q = sim::measureCloth(parameters(), sheet(1), still, 0);
  CHECK(named(parameters(), q, "population") == 9);
  CHECK(named(parameters(), q, "mass") == 18);
  CHECK(named(parameters(), q, "kineticEnergy") == 0);
  CHECK(named(parameters(), q, "elasticEnergy") == doctest::Approx(0).epsilon(1e-12));
  CHECK(named(parameters(), q, "stretch") == 1);
  CHECK(named(parameters(), q, "speed") == 0);
  // The middle row is at the mean height: 18 kg * 9.8 m/s^2 * 0.5 m.
  CHECK(named(parameters(), q, "potentialEnergy") == doctest::Approx(18 * 9.8 * 0.5).epsilon(1e-6));
}

TEST_CASE("a stretched cloth has the expected elastic energy") {
  // x is scaled by 3/2. Then 6 springs along x are 0.25 m longer, 8 diagonals have the length sqrt(0.75^2 +
  // 0.5^2) instead of sqrt(0.5), and 3 springs across two cells are 0.5 m longer. Springs along y keep
  // their length.
  const auto q = sim::measureCloth(parameters(), sheet(1.5F), still, 0);
  const double diagonal = std::sqrt(0.8125) - std::sqrt(0.5);
  const double expected = 6 * 0.5 * 16 * 0.0625 + 8 * 0.5 * 8 * diagonal * diagonal + 3 * 0.5 * 4 * 0.25;
  CHECK(named(parameters(), q, "elasticEnergy") == doctest::Approx(expected).epsilon(1e-12));
  CHECK(named(parameters(), q, "stretch") == doctest::Approx(1.5).epsilon(1e-12));
  CHECK(named(parameters(), q, "energy") == doctest::Approx(expected + 18 * 9.8 * 0.5).epsilon(1e-6));
}

TEST_CASE("compliant constraints store elastic energy, rigid ones none") {
  auto p = parameters();
  p.solver = sim::ClothSolver::constraints;
  p.compliance = 0;
  p.shearCompliance = 0;
  p.bendCompliance = 0.25F;
  CHECK(named(p, sim::measureCloth(p, sheet(1.5F), still, 0), "elasticEnergy") ==
        doctest::Approx(3 * 0.5 * 4 * 0.25).epsilon(1e-12));
  p.bendCompliance = 0;
  p.compliance = 0.125F;
  CHECK(named(p, sim::measureCloth(p, sheet(1.5F), still, 0), "elasticEnergy") ==
        doctest::Approx(6 * 0.5 * 8 * 0.0625).epsilon(1e-12));
}

TEST_CASE("a moving cloth has the expected kinetic energy and speed") {
  auto velocities = still;
  velocities[4] = glm::vec4(3, 0, -4, 7);  // w is the pin group, which must be ignored.
  const auto q = sim::measureCloth(parameters(), sheet(1), velocities, 0);
  CHECK(named(parameters(), q, "kineticEnergy") == 25);
  CHECK(named(parameters(), q, "speed") == 5);
}

TEST_CASE("potential energy follows the animated gravity") {
  auto p = parameters();
  p.gravity =
      scene::Animated<glm::vec3>({{0.0, glm::vec3(0)}, {2.0, glm::vec3(-4, 0, 0)}}, scene::Ease::linear);
  CHECK(named(p, sim::measureCloth(p, sheet(1), still, 0), "potentialEnergy") == 0);
  CHECK(named(p, sim::measureCloth(p, sheet(1), still, 1), "potentialEnergy") == 18 * 2 * 0.5);
}

TEST_CASE("a NaN makes every quantity NaN that depends on it") {
  auto positions = sheet(1);
  positions[0].y = std::numeric_limits<float>::quiet_NaN();
  const auto q = sim::measureCloth(parameters(), positions, still, 0);
  for (const char* name : {"potentialEnergy", "elasticEnergy", "energy", "stretch"})
    CHECK_MESSAGE(std::isnan(named(parameters(), q, name)), name);
  CHECK(named(parameters(), q, "population") == 9);
}
