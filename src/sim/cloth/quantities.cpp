#include "sim/cloth/quantities.hpp"

#include "base/error.hpp"
#include "sim/cloth/plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace simreel::sim {

namespace {

struct Springs {
  double energy = 0;   ///< J
  double stretch = 0;  ///< largest |d| / L0 of a structural spring
};

/// The larger one; NaN once there was one, which std::max and std::fmax would lose.
double larger(double a, double b) {
  return std::isnan(a) || a >= b ? a : b;
}

/// N/m, by the kind of spring. Springs as forces have the stiffnesses of the parameters. A constraint of
/// compliance c stores C^2 / (2 c) (Macklin et al. 2016), so 1/c stands for its stiffness; one of
/// compliance 0 is rigid and stores nothing.
std::array<double, 3> stiffnesses(const ClothParameters& p) {
  const double k = p.stiffness;
  if (p.solver != ClothSolver::constraints) return {k, k * p.shear, k * p.bend};
  const auto inverse = [](float compliance) { return compliance > 0 ? 1.0 / compliance : 0.0; };
  return {inverse(p.compliance), inverse(p.shearCompliance), inverse(p.bendCompliance)};
}

/// E = sum 1/2 k (|d| - L0)^2.
void addFamily(const SpringFamily& family, double stiffness, double spacing, glm::ivec2 size,
               std::span<const glm::vec4> positions, Springs& sum) {
  const double restLength = spacing * std::hypot(family.reach.x, family.reach.y);
  const auto width = static_cast<std::size_t>(size.x);
  const auto at = [&](int x, int y) {
    return positions[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
  };
  for (int y = 0; y + family.reach.y < size.y; ++y)
    for (int x = std::max(0, -family.reach.x); x + std::max(0, family.reach.x) < size.x; ++x) {
      const glm::dvec3 here(at(x, y));
      const glm::dvec3 d = glm::dvec3(at(x + family.reach.x, y + family.reach.y)) - here;
      const double length = std::sqrt(glm::dot(d, d));
      const double beyond = length - restLength;
      sum.energy += 0.5 * stiffness * beyond * beyond;
      if (family.kind == 0) sum.stretch = larger(sum.stretch, length / restLength);
    }
}

}  // namespace

std::span<const scene::Quantity> ClothParameters::quantities() const {
  static const scene::Quantity table[] = {
      {"population", "", "Particles."},
      {"mass", "kg", "Of all particles, the pinned ones included."},
      {"kineticEnergy", "J", "Of all particles."},
      {"potentialEnergy", "J", "In the field of gravity, against the plane through the origin across it."},
      {"elasticEnergy", "J", "Of all springs; of the constraints solver that of compliant constraints."},
      {"energy", "J", "Kinetic, potential and elastic."},
      {"stretch", "", "Largest length of a structural spring as a ratio to rest."},
      {"speed", "m/s", "Of the fastest particle."}};
  return table;
}

std::vector<double> measureCloth(const ClothParameters& parameters, std::span<const glm::vec4> positions,
                                 std::span<const glm::vec4> velocities, double time) {
  SIMREEL_CHECK_EQ(positions.size(), velocities.size());
  SIMREEL_CHECK_EQ(positions.size(), static_cast<std::size_t>(parameters.size.x) *
                                         static_cast<std::size_t>(parameters.size.y));
  const double mass = parameters.mass;
  const glm::dvec3 gravity(parameters.gravity.at(time));
  double kinetic = 0;
  double potential = 0;
  double fastestSquared = 0;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const glm::dvec3 v(velocities[i]);
    const double squared = glm::dot(v, v);
    kinetic += 0.5 * mass * squared;                                  // T = 1/2 m v^2
    potential -= mass * glm::dot(gravity, glm::dvec3(positions[i]));  // U = -m g.x
    fastestSquared = larger(fastestSquared, squared);
  }
  Springs springs;
  const auto stiffness = stiffnesses(parameters);
  for (const SpringFamily& family : springFamilies)
    addFamily(family, stiffness[static_cast<std::size_t>(family.kind)], parameters.spacing, parameters.size,
              positions, springs);
  const auto count = static_cast<double>(positions.size());
  return {count,           count * mass,
          kinetic,         potential,
          springs.energy,  kinetic + potential + springs.energy,
          springs.stretch, std::sqrt(fastestSquared)};
}

}  // namespace simreel::sim
