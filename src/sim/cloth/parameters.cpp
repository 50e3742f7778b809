#include "sim/cloth/parameters.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace simreel::sim {

namespace {

constexpr int maxSubsteps = 1024;
/// Fraction of the stable substep that "auto" takes. Half of its square: a sheet stretched to any length
/// pulls sideways as strongly as along its springs at most, which doubles the square of its fastest
/// frequency.
constexpr double safety = 0.7;

/// Greatest speed of the air, m/s: on a straight way between keys it is greatest at one of them, and each
/// component of a gust comes up to its share.
double fastestAir(const Air& air) {
  double fastest = 0;
  for (const auto& key : air.velocity.keys()) {
    const glm::dvec3 v(key.value);
    fastest = std::max(fastest, std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z));
  }
  return fastest * (1.0 + std::sqrt(3.0) * air.gusts);
}

/// Substeps of a frame, none of them longer than `longest`; at most 1e15.
std::int64_t substepsFor(double frameSeconds, double longest) {
  return static_cast<std::int64_t>(std::ceil(std::min(frameSeconds / longest, 1e15)));
}

void checkLines(scene::Fields& f, const char* name, const std::vector<int>& lines, int count) {
  for (const int line : lines)
    if (line >= count || line < -count)
      f.error(name,
              fmt::format("{} {} is outside the cloth: it has {} (0 to {}, or -1 for the last)",
                          std::string_view(name) == "rows" ? "row" : "column", line, count, count - 1));
}

}  // namespace

ClothParameters::ClothParameters() {
  PinGroup lastRow;
  lastRow.rows = {-1};
  pins.push_back(lastRow);
}

void PinGroup::describe(scene::Fields& f, const glm::ivec2& grid) {
  f.integers("rows", rows, {-1e6, 1e6}, "", "Rows to pin; negative ones count from the last.");
  f.integers("columns", columns, {-1e6, 1e6}, "", "Columns to pin; negative ones count from the last.");
  f.someOf("corners", corners, {"top-left", "top-right", "bottom-left", "bottom-right"},
           "Corners to pin; row 0 is the top.");
  f.pairs("points", points, {0, 1e6}, "", "Single particles to pin, each [x, y].");
  f.integer("every", every, {1, 1e6}, "", "Of rows and columns pin only each n-th particle, and the last.");
  f.vector("move", move, scene::anyNumber, "m", "How far the pins are moved.");
  f.vector("rotate", rotate, scene::anyNumber, "degrees", "Rotation of the pins about the pivot.");
  f.vector("scale", scale, {-1e3, 1e3}, "", "Scale of the pins about the pivot.");
  f.vector("pivot", pivot, scene::anyNumber, "m", "Fixed point of rotation and scale, in world space.");
  checkLines(f, "rows", rows, grid.y);
  checkLines(f, "columns", columns, grid.x);
  for (const glm::ivec2& p : points)
    if (p.x >= grid.x || p.y >= grid.y)
      f.error("points",
              fmt::format("[{}, {}] is outside the cloth of {}x{} particles", p.x, p.y, grid.x, grid.y));
}

void ClothParameters::describe(scene::Fields& f) {
  f.pair("size", size, {2, 16384}, "particles", "Particles along a row and number of rows.");
  f.number("spacing", spacing, {1e-4, 1e3}, "m", "Rest distance between neighbours.");
  f.vector("position", position, scene::anyNumber, "m", "Middle of the sheet at rest.");
  f.vector("rotation", rotation, scene::anyNumber, "degrees",
           "About x, then y, then z; unrotated the sheet lies flat, rows along x.");
  f.number("jitter", jitter, {0, 10}, "m", "Largest random displacement of the particles at the start.");
  f.number("mass", mass, {1e-6, 1e6}, "kg", "Of each particle.");
  f.number("stiffness", stiffness, {0, 1e9}, "N/m", "Of the structural springs.");
  f.number("shear", shear, {0, 100}, "", "Stiffness of the diagonal springs as a ratio to stiffness.");
  f.number("bend", bend, {0, 100}, "", "Stiffness of the springs of length two as a ratio to stiffness.");
  f.choice("solver", solver, {"springs", "constraints"},
           "Springs as forces, or the same lengths kept by XPBD constraints, stable at any stiffness.");
  f.number("compliance", compliance, {0, 1e6}, "m/N", "Of structural constraints; 0 cannot stretch.");
  f.number("shearCompliance", shearCompliance, {0, 1e6}, "m/N", "Of diagonal constraints.");
  f.number("bendCompliance", bendCompliance, {0, 1e6}, "m/N", "Of constraints of length two.");
  f.number("damping", damping, {0, 1e4}, "1/s", "Rate at which velocity decays.");
  f.vector("gravity", gravity, scene::anyNumber, "m/s^2", "Acceleration of every particle.");
  f.vector("wind", wind, scene::anyNumber, "N", "Constant force on every particle.");
  f.optionalGroup("air", hasAir, "Moving air that drags and lifts the cloth's faces.",
                  [&](scene::Fields& a) {
                    a.vector("velocity", air.velocity, {-200, 200}, "m/s", "Of the air.");
                    a.number("density", air.density, {0, 1e4}, "kg/m^3", "Of the air.");
                    a.number("drag", air.drag, {0, 100}, "", "Drag coefficient.");
                    a.number("lift", air.lift, {0, 100}, "", "Lift coefficient.");
                    a.number("gusts", air.gusts, {0, 10}, "",
                             "How much the velocity varies, as a fraction of its magnitude.");
                    a.number("gustSize", air.gustSize, {1e-2, 1e3}, "m", "Size of the gusts.");
                  });
  f.number("margin", margin, {0, 10}, "m", "Distance kept from colliders.");
  f.text("walls", walls, "Name of the cave or contour whose walls, floor and tops it meets.");
  f.integerOr("substeps", substeps, "auto", {1, maxSubsteps}, "per frame",
              "Steps a frame is divided into; \"auto\" takes as many as the springs need to be stable.");
  f.list("pins", pins, "Particles that are held, and how they move.",
         [&](scene::Fields& p, PinGroup& group) { group.describe(p, size); });
  if (pins.size() > shader::maxPinFrames)
    f.error("pins", fmt::format("at most {} groups of pins", shader::maxPinFrames));
}

double ClothParameters::greatestLoad() const {
  const auto greatest = [](const scene::Animated<glm::vec3>& vector) {
    double most = 0;
    for (const auto& key : vector.keys()) {
      const glm::dvec3 v(key.value);
      most = std::max(most, std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z));
    }
    return most;
  };
  return greatest(gravity) + greatest(wind) / mass;
}

double ClothParameters::stableSeconds() const {
  // Semi-implicit Euler of x'' = -w^2 x - c x' stays bounded while (w dt)^2 + 2 c dt < 4. At rest the
  // lattice's fastest mode has w^2 <= 4 (k + ks + kb) / m. Drag alone slows down at c = rho (Cd + Cl) A |v|
  // / m: the force's half of the square, differentiated.
  // Constraints do not limit it by themselves; but the weight of N particles that hang on a line pulls it
  // straight with T = N m a, and a straight line of masses swings sideways with w^2 <= 4 T / (m L) = 4 N a
  // / L.
  const double hanging = 4.0 * std::max(size.x, size.y) * greatestLoad() / spacing;
  const double w2 = solver == ClothSolver::springs
                        ? 4.0 * static_cast<double>(stiffness) * (1.0 + shear + bend) / mass
                        : hanging;
  const double c = hasAir ? air.density * static_cast<double>(air.drag + air.lift) * spacing * spacing *
                                fastestAir(air) / mass
                          : 0.0;
  const double rate = c + std::sqrt(c * c + 4.0 * w2);
  return rate > 0 ? 4.0 / rate : std::numeric_limits<double>::infinity();
}

std::string ClothParameters::steadierWay(double frameSeconds) const {
  ClothParameters other = *this;
  if (substeps && substepsFor(frameSeconds, safety * stableSeconds()) <= maxSubsteps)
    return "set \"substeps\": \"auto\", lower the stiffness or raise the mass";
  other.solver = ClothSolver::constraints;
  if (solver == ClothSolver::springs &&
      substepsFor(frameSeconds, safety * other.stableSeconds()) <= maxSubsteps)
    return "set \"solver\": \"constraints\" (XPBD), which is stable at any stiffness, lower the stiffness "
           "or "
           "raise the mass";
  return "slow the air, lower its density, drag or lift, or raise the mass";
}

std::string ClothParameters::instability(double frameSeconds) const {
  const double stable = stableSeconds();
  if (!substeps || frameSeconds / *substeps <= stable) return "";
  return fmt::format(
      "{} substeps are fewer than the {} that its {} need to be stable (substep {:.3g} s, limit {:.3g} s); "
      "{}",
      *substeps, substepsFor(frameSeconds, stable),
      std::string(solver == ClothSolver::springs ? "springs" : "hanging rows") +
          (hasAir ? " and the fastest air" : ""),
      frameSeconds / *substeps, stable, steadierWay(frameSeconds));
}

int ClothParameters::substepsPerFrame(double frameSeconds) const {
  if (substeps) return *substeps;
  const std::int64_t needed = substepsFor(frameSeconds, safety * stableSeconds());
  if (needed > maxSubsteps)
    fail(ExitCode::usage,
         "cloth: \"substeps\": \"auto\" would take {} a frame to be stable, more than {}; {}", needed,
         maxSubsteps, steadierWay(frameSeconds));
  const int min = solver == ClothSolver::constraints ? 8 : 1;
  return std::max(static_cast<int>(needed), min);
}

std::vector<int> ClothParameters::pinnedBy(const PinGroup& group) const {
  std::set<int> found;
  const auto chosen = [&](int i, int count) { return i % group.every == 0 || i == count - 1; };
  for (const int row : group.rows)
    for (int x = 0; x < size.x; ++x)
      if (chosen(x, size.x)) found.insert((row < 0 ? row + size.y : row) * size.x + x);
  for (const int column : group.columns)
    for (int y = 0; y < size.y; ++y)
      if (chosen(y, size.y)) found.insert(y * size.x + (column < 0 ? column + size.x : column));
  for (const int corner : group.corners)
    found.insert((corner >= 2 ? size.y - 1 : 0) * size.x + (corner % 2 == 1 ? size.x - 1 : 0));
  for (const glm::ivec2& p : group.points) found.insert(p.y * size.x + p.x);
  return {found.begin(), found.end()};
}

}  // namespace simreel::sim
