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
  double energy = 0;   ///< elastic energy in J
  double stretch = 0;  ///< maximum strain |length - L0| / L0 of a structural spring with the rest length L0
};

/// Returns the maximum, or NaN if either argument is NaN; std::max and std::fmax would lose the NaN.
double larger(double a, double b) {
  return std::isnan(a) || a >= b ? a : b;
}

/// Returns the stiffness (N/m) for each kind of spring. Springs that act as forces have the stiffnesses of
/// the parameters. A constraint with the stretch C and the compliance c stores the energy C^2 / (2 c)
/// (Macklin et al. 2016), so its stiffness is 1/c. A constraint with compliance 0 is rigid and stores no
/// energy, so its entry is 0.
std::array<double, 3> stiffnesses(const ClothParameters& p) {
  const double k = p.stiffness;
  if (!p.constrained()) return {k, k * p.shear, k * p.bend};
  const auto inverse = [](float compliance) { return compliance > 0 ? 1.0 / compliance : 0.0; };
  return {inverse(p.compliance), inverse(p.shearCompliance), inverse(p.bendCompliance)};
}

/// Returns the weight of a row or column in sums over the area: 1/2 at a border, 1 inside.
double share(int line, int count) {
  return line == 0 || line == count - 1 ? 0.5 : 1.0;
}

/// Returns the stiffness (N/m) of the fabric link that starts at `from`. A link along a border has half the
/// stiffness.
double linkStiffness(const ClothParameters& p, const SpringFamily& family, glm::ivec2 from) {
  const shader::FabricConstants fabric = p.fabric->ofLinks(p.fabric->constants().shear);
  if (family.kind != 0) return family.kind == 1 ? fabric.shear : 0;
  return family.reach.x != 0 ? fabric.weft * share(from.y, p.size.y)
                             : fabric.warp * share(from.x, p.size.x);
}

/// Returns the bending energy of a plate in J: D / (2 L^2) (sum of |Dxx|^2 + |Dyy|^2 over inner nodes + 2
/// sum of |Dxy|^2 over cells), with the stiffness D, the spacing L and the second differences Dxx, Dyy and
/// Dxy of positions. Clamped borders contribute nothing here.
double bendingEnergy(const ClothParameters& p, std::span<const glm::vec4> positions) {
  const auto at = [&](int x, int y) {
    return glm::dvec3(positions[static_cast<std::size_t>(y) * static_cast<std::size_t>(p.size.x) +
                                static_cast<std::size_t>(x)]);
  };
  const auto squared = [](const glm::dvec3& v) { return glm::dot(v, v); };
  double sum = 0;
  for (int y = 0; y < p.size.y; ++y)
    for (int x = 0; x < p.size.x; ++x) {
      if (x > 0 && x + 1 < p.size.x)
        sum += share(y, p.size.y) * squared(at(x - 1, y) - 2.0 * at(x, y) + at(x + 1, y));
      if (y > 0 && y + 1 < p.size.y)
        sum += share(x, p.size.x) * squared(at(x, y - 1) - 2.0 * at(x, y) + at(x, y + 1));
      if (x + 1 < p.size.x && y + 1 < p.size.y)
        sum += 2 * squared(at(x, y) - at(x + 1, y) - at(x, y + 1) + at(x + 1, y + 1));
    }
  return 0.5 * p.fabric->constants().bending / (static_cast<double>(p.spacing) * p.spacing) * sum;
}

/// Adds a family's energy E = sum 1/2 k (|d| - L0)^2 to `sum`, for springs with the vector d, the rest
/// length L0 and the stiffness k. For structural springs also records the maximum stretch.
void addFamily(const ClothParameters& p, const SpringFamily& family, double stiffness,
               std::span<const glm::vec4> positions, Springs& sum) {
  const glm::ivec2 size = p.size;
  const double restLength = p.spacing * std::hypot(family.reach.x, family.reach.y);
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
      const double k = p.fabric ? linkStiffness(p, family, {x, y}) : stiffness;
      sum.energy += 0.5 * k * beyond * beyond;
      if (family.kind == 0) sum.stretch = larger(sum.stretch, length / restLength);
    }
}

/// Returns the compliance of a constraint in m/N: 1 / stiffness, or 0 if the constraint is rigid.
double complianceOf(const ClothParameters& p, const SpringFamily& family, double stiffness,
                    glm::ivec2 from) {
  if (p.fabric) return 1 / linkStiffness(p, family, from);
  return stiffness > 0 ? 1 / stiffness : 0;
}

/// Returns the minimum compliance of a line's links, as a ratio to the inverse masses. It equals
/// minCompliance in glsl/cloth/segment.glsl.
double minCompliance(std::span<const glm::vec4> line, double rest, double softening) {
  if (std::count_if(line.begin(), line.end(), [](const glm::vec4& p) { return p.w == 0; }) < 2) return 0;
  const double minimum = 0.125 / softening;
  if (line.front().w > 0 || line.back().w > 0) return minimum;
  const glm::dvec3 d(glm::vec3(line.back()) - glm::vec3(line.front()));
  return std::max(3 * (std::sqrt(glm::dot(d, d)) / (rest * static_cast<double>(line.size() - 1)) - 1),
                  minimum);
}

/// Returns the energy of softened constraints with the stretches C: 1/2 C^T B^-1 C for lines, where B =
/// compliance + softening seconds^2 G W G^T with the gradients G and the inverse masses W, and 1/2 C^2 / b
/// for pairs, where b is the diagonal element of B.
double keptEnergy(const ClothParameters& p, const SpringFamily& family, double stiffness,
                  std::span<const glm::vec4> positions, const Softness& softness) {
  const double restLength = p.spacing * std::hypot(family.reach.x, family.reach.y);
  const bool line = family.kind == 0;
  const double soft = (line ? softness.lines : std::max(softness.lines, pairSoftening)) * softness.seconds *
                      softness.seconds;
  const auto inside = [&](glm::ivec2 at) { return at.x >= 0 && at.x < p.size.x && at.y < p.size.y; };
  const auto at = [&](glm::ivec2 where) {
    return positions[static_cast<std::size_t>(where.y) * static_cast<std::size_t>(p.size.x) +
                     static_cast<std::size_t>(where.x)];
  };
  double energy = 0;
  for (int y = 0; y < p.size.y; ++y)
    for (int x = 0; x < p.size.x; ++x) {
      // All links of a line are solved together when the loop reaches its first particle, by Gaussian
      // elimination without pivoting.
      if (line && (family.reach.x > 0 ? x : y) > 0) continue;
      double pivot = 1;
      double right = 0;
      glm::dvec3 before(0);
      std::vector<glm::vec4> whole;
      for (glm::ivec2 from(x, y); line && inside(from); from += family.reach) whole.push_back(at(from));
      const double give = line ? minCompliance(whole, restLength, softness.lines) : 0.0;
      for (glm::ivec2 from(x, y); inside(from + family.reach); from += family.reach) {
        const glm::dvec4 a(at(from));
        const glm::dvec4 b(at(from + family.reach));
        const glm::dvec3 d = glm::dvec3(b) - glm::dvec3(a);
        const double length = std::sqrt(glm::dot(d, d));
        const glm::dvec3 along = d / length;
        const double lower = line ? -soft * a.w * glm::dot(before, along) : 0.0;
        const double weight = soft * (a.w + b.w);
        const double diagonal = weight + std::max(complianceOf(p, family, stiffness, from), give * weight);
        right = length - restLength - lower / pivot * right;
        pivot = diagonal - lower / pivot * lower;
        before = along;
        if (diagonal > 0) {
          energy += 0.5 * right * right / pivot;
        } else {  // The link is rigid and both of its particles are pinned.
          pivot = 1;
          right = 0;
          before = glm::dvec3(0);
        }
        if (!line) break;
      }
    }
  return energy;
}

}  // namespace

std::span<const scene::Quantity> ClothParameters::quantities() const {
  static const scene::Quantity table[] = {
      {"population", "", "Number of particles."},
      {"mass", "kg", "Mass of all particles, including the pinned ones."},
      {"kineticEnergy", "J", "Kinetic energy of all particles."},
      {"potentialEnergy", "J",
       "Potential energy in the field of gravity, relative to the plane through the origin at right angles "
       "to it."},
      {"elasticEnergy", "J",
       "Energy of all springs, or of compliant constraints; a fabric adds its bending. For a mesh, and "
       "without damping, the stiffness that the substeps leave counts."},
      {"energy", "J", "Kinetic, potential and elastic."},
      {"stretch", "",
       "Largest ratio of a structural spring's length to its rest length; for a mesh, of a face along weft "
       "or warp."},
      {"speed", "m/s", "Speed of the fastest particle."}};
  return table;
}

std::vector<glm::vec4> beforeHalf(std::span<const glm::vec4> positions,
                                  std::span<const glm::vec4> velocities, double seconds) {
  std::vector<glm::vec4> before(positions.begin(), positions.end());
  for (std::size_t i = 0; i < before.size(); ++i)
    before[i] = glm::vec4(
        glm::vec3(before[i]) - glm::vec3(velocities[i]) * static_cast<float>(0.5 * seconds), before[i].w);
  return before;
}

// A substep moves a particle by dt u + dt p / 18 + s, where v' = u + p' and p' = p / 3 + s / h (symbols as
// in glsl/cloth/motion.glsl). Divided by dt, the actual velocity is v' - p' / 3 - p / 6, which equals v' -
// p' / 2 if the trend is steady.
std::vector<glm::vec4> actualVelocities(std::span<const glm::vec4> positions,
                                        std::span<const glm::vec4> velocities,
                                        std::span<const glm::vec4> trends) {
  std::vector<glm::vec4> actual(velocities.begin(), velocities.end());
  for (std::size_t i = 0; i < std::min(actual.size(), trends.size()); ++i)
    if (positions[i].w > 0)
      actual[i] = glm::vec4(glm::vec3(actual[i]) - 0.5F * glm::vec3(trends[i]), actual[i].w);
  return actual;
}

std::vector<double> measureCloth(const ClothParameters& parameters, std::span<const glm::vec4> left,
                                 std::span<const glm::vec4> velocities, double time,
                                 const Softness& softness) {
  const std::vector<glm::vec4> positions = beforeHalf(left, velocities, softness.seconds);
  SIMREEL_CHECK_EQ(positions.size(), velocities.size());
  SIMREEL_CHECK_EQ(positions.size(), static_cast<std::size_t>(parameters.size.x) *
                                         static_cast<std::size_t>(parameters.size.y));
  const glm::dvec3 gravity(parameters.gravity.at(time));
  double kinetic = 0;
  double potential = 0;
  double fastestSquared = 0;
  double total = 0;
  const auto width = static_cast<std::size_t>(parameters.size.x);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double mass = parameters.particleMass({static_cast<int>(i % width), static_cast<int>(i / width)});
    total += mass;
    const glm::dvec3 v(velocities[i]);
    const double squared = glm::dot(v, v);
    kinetic += 0.5 * mass * squared;                                  // kinetic energy T = 1/2 m v^2
    potential -= mass * glm::dot(gravity, glm::dvec3(positions[i]));  // potential energy U = -m g.x, where
                                                                      // g is the gravity vector
    fastestSquared = larger(fastestSquared, squared);
  }
  Springs springs;
  const auto stiffness = stiffnesses(parameters);
  for (const SpringFamily& family : springFamilies)
    addFamily(parameters, family, stiffness[static_cast<std::size_t>(family.kind)], positions, springs);
  if (softness.lines > 0) {
    springs.energy = 0;
    for (const SpringFamily& family : springFamilies)
      if (!parameters.fabric || family.kind < 2)
        springs.energy += keptEnergy(parameters, family, stiffness[static_cast<std::size_t>(family.kind)],
                                     positions, softness);
  }
  if (parameters.fabric) springs.energy += bendingEnergy(parameters, positions);
  const auto count = static_cast<double>(positions.size());
  return {count,           total,
          kinetic,         potential,
          springs.energy,  kinetic + potential + springs.energy,
          springs.stretch, std::sqrt(fastestSquared)};
}

}  // namespace simreel::sim
