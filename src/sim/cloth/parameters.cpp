#include "sim/cloth/parameters.hpp"

#include "base/error.hpp"
#include "sim/body/skinned_surface.hpp"
#include "sim/contact/lock_step.hpp"
#include "sim/contour/walls.hpp"
#include "sim/core/collider.hpp"
#include "sim/fluid/wind.hpp"
#include "sim/mesh/height_field.hpp"
#include "sim/ports/color_scale.hpp"
#include "sim/ports/markers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace simreel::sim {

namespace {

constexpr int maxSubsteps = 1024;
/// Fraction of the maximum stable substep that "auto" uses. Its square is 1/2, because a stretched sheet
/// pulls sideways at most as strongly as along its springs, which doubles the square of its maximum
/// frequency.
constexpr double safety = 0.7;

/// Returns the minimum number of substeps per frame such that a substep takes at most `longest` (seconds),
/// limited to 1e15.
std::int64_t substepsFor(double frameSeconds, double longest) {
  return static_cast<std::int64_t>(std::ceil(std::min(frameSeconds / longest, 1e15)));
}

}  // namespace

ClothParameters::ClothParameters() {
  PinGroup lastRow;
  lastRow.rows = {-1};
  pins.push_back(lastRow);
}

/// Declares "mesh" and "seams". A cloth with a mesh is a fabric and by default has no pins.
void ClothParameters::describeMesh(scene::Fields& f) {
  f.optionalGroup("mesh", mesh, "Triangles that the cloth is made of, instead of a grid; a fabric.");
  f.list("seams", seams, "Vertices that are sewn together in pairs; for a cloth with a \"mesh\".",
         [](scene::Fields& s, Seam& seam) {
           s.integers(
               "from", seam.from, {0, 1e7}, "",
               "Vertices of one side, from 0 on, in the order in which \"simreel bake\" writes them.");
           s.integers("to", seam.to, {0, 1e7}, "",
                      "The same number of vertices of the other side, in the same order.");
           s.number("seconds", seam.seconds, {1e-3, 1e6}, "s", "Time until the seam has pulled shut.");
           if (seam.from.size() != seam.to.size())
             s.error("to", fmt::format("{} vertices are sewn to {}; each needs one", seam.from.size(),
                                       seam.to.size()));
         });
  if (!seams.empty() && !mesh) f.error("seams", "a grid has no seams; give \"mesh\"");
  if (!mesh) return;
  for (const char* name : {"size", "spacing"})
    if (f.given(name))
      f.error(name, fmt::format("\"mesh\" already determines the particles; leave out \"{}\"", name));
  if (!f.given("pins")) pins.clear();
}

void ClothParameters::describe(scene::Fields& f) {
  describeMesh(f);
  f.pair("size", size, {2, 16384}, "particles", "Particles along a row and number of rows.");
  f.number("spacing", spacing, {1e-4, 1e3}, "m", "Rest distance between neighbours.");
  f.vector("position", position, scene::anyNumber, "m",
           "Place of the middle of the sheet at rest, or of the origin of a mesh.");
  f.vector("rotation", rotation, scene::anyNumber, "degrees",
           "About x, then y, then z; without rotation the sheet lies flat with rows along x, and a mesh as "
           "in its file.");
  f.number("jitter", jitter, {0, 10}, "m", "Largest random displacement of the particles at the start.");
  f.number("mass", mass, {1e-6, 1e6}, "kg", "Mass of each particle.");
  f.number("stiffness", stiffness, {0, 1e9}, "N/m",
           "Stiffness of the structural springs, which join neighbours.");
  f.number("shear", shear, {0, 100}, "", "Stiffness of the diagonal springs as a ratio to stiffness.");
  f.number("bend", bend, {0, 100}, "", "Stiffness of the springs of length two as a ratio to stiffness.");
  f.choice("solver", solver, {"springs", "constraints"},
           "Springs as forces, or the same lengths kept by XPBD constraints, stable at any stiffness.");
  f.number("compliance", compliance, {0, 1e6}, "m/N",
           "Compliance of structural constraints; with 0 the cloth cannot stretch.");
  f.number("shearCompliance", shearCompliance, {0, 1e6}, "m/N", "Compliance of diagonal constraints.");
  f.number("bendCompliance", bendCompliance, {0, 1e6}, "m/N",
           "Compliance of constraints between particles two steps apart.");
  f.shorthand("fabric", "material");
  f.optionalGroup("fabric", fabric,
                  "A material by its properties per area and length, whatever the spacing, instead of "
                  "\"mass\", springs and their constraints; lengths are kept by XPBD.");
  if (mesh && !fabric) fabric.emplace();
  if (fabric) {
    for (const char* name :
         {"mass", "stiffness", "shear", "bend", "compliance", "shearCompliance", "bendCompliance"})
      if (f.given(name))
        f.error(name, fmt::format("\"fabric\" already sets this property; leave out \"{}\"", name));
    if (f.given("solver") && solver == ClothSolver::springs)
      f.error("solver", "a fabric is solved by constraints; leave out \"solver\"");
  }
  if (!fabric) {
    const bool springs = solver == ClothSolver::springs;
    f.idleUnless(springs, "solver", {"stiffness", "shear", "bend"}, "\"solver\": \"springs\"");
    f.idleUnless(!springs, "solver", {"compliance", "shearCompliance", "bendCompliance"},
                 "\"solver\": \"constraints\"");
  }
  f.number(
      "damping", damping, {0, 1e4}, "1/s",
      "Rate at which velocity decays. With 0, constraints and fabrics in still air without contact keep "
      "their energy, which takes more substeps.");
  f.vector("gravity", gravity, scene::anyNumber, "m/s^2", "Acceleration of every particle.");
  f.vector("wind", wind, scene::anyNumber, "N", "Constant force on every particle.");
  f.leftOut("wind", fabric ? "none on a fabric" : "[0.5,0,0.3], or none on a fabric");
  if (fabric && !f.given("wind")) wind = glm::vec3(0);
  f.optionalGroup("air", air, "Moving air that drags and lifts the cloth's faces.",
                  [](scene::Fields& a, Air& moving) {
                    a.vector("velocity", moving.velocity, {-200, 200}, "m/s", "Velocity of the air.");
                    a.number("density", moving.density, {0, 1e4}, "kg/m^3", "Density of the air.");
                    a.number("drag", moving.drag, {0, 100}, "", "Drag coefficient.");
                    a.number("lift", moving.lift, {0, 100}, "", "Lift coefficient.");
                    a.number("gusts", moving.gusts, {0, 10}, "",
                             "Variation of the velocity, as a fraction of its magnitude.");
                    a.number("gustSize", moving.gustSize, {1e-2, 1e3}, "m", "Size of the gusts.");
                    a.text("fluid", moving.fluid,
                           "Name of a fluid whose wind is added to the air's velocity where its \"plane\" "
                           "lies; its flow at the end of the frame counts.");
                    a.number("fluidSpeed", moving.fluidSpeed, {0, 200}, "m/s",
                             "Greatest wind speed that is expected of the fluid, for \"auto\" substeps.");
                    a.idleUnless(moving.gusts > 0, "gusts", {"gustSize"}, "air with \"gusts\"");
                    a.idleUnless(!moving.fluid.empty(), "fluid", {"fluidSpeed"}, "air with a \"fluid\"");
                  });
  f.number(
      "margin", margin, {0, 10}, "m",
      "Distance kept from colliders. Vertices collide; 0.35 of \"spacing\" keeps their faces off sharp "
      "edges.");
  f.leftOut("margin", "0.35 of \"spacing\", at least 0.01; in a scene of version 1 0.01");
  if (!f.given("margin") && f.version() > 1 && !mesh) margin = std::max(margin, 0.35F * spacing);
  if (f.version() > 1 && !mesh) smallColliders = 2.5F;
  f.switchable("contact");
  f.optionalGroup(
      "contact", contact,
      "Faces and edges keep a distance from each other, from other cloths with \"contact\", and from "
      "meshes and bodies with \"collides\": \"faces\".",
      [&](scene::Fields& c, ClothContact& own) {
        c.optionalNumber("thickness", own.thickness, {1e-6, 10}, "m",
                         "Distance that is kept between the middles of two layers, and from meshes and "
                         "bodies; around small triangles of a mesh it is less.");
        c.leftOut("thickness", "the fabric's, limited to 0.125 to 0.35 of the distance between neighbours");
        c.number("friction", own.friction, {0, 10}, "",
                 "Coulomb's coefficient; between cloths the mean of theirs, and of a mesh or body that has "
                 "one.");
        if (own.thickness && !mesh && *own.thickness > 0.35 * static_cast<double>(spacing))
          c.error("thickness",
                  fmt::format("thickness {} is more than 0.35 of the spacing of {} m, so neighbours in the "
                              "cloth could not keep that distance; use at most {:.4g}",
                              *own.thickness, spacing, 0.35 * static_cast<double>(spacing)));
      });
  f.text("walls", walls, "Name of the cave or contour whose walls, floor and tops it meets.");
  f.integerOr("substeps", substeps, "auto", {1, maxSubsteps}, "per frame",
              "Steps that a frame is divided into; \"auto\" takes as many as the springs need to be "
              "stable, and as undamped constraints need to keep their energy.");
  f.leftOut("substeps", fabric ? "\"auto\" of a fabric" : "4, or \"auto\" of a fabric");
  if (fabric && !f.given("substeps")) substeps.reset();
  if (!f.given("pins") && f.version() > 1) pins.clear();
  f.list("pins", pins, "Particles that are held, and how they move; [] holds none.",
         [&](scene::Fields& p, PinGroup& group) { group.describe(p, size, mesh.has_value()); });
  f.leftOut("pins", "none; in a scene of version 1 the last row");
  pinsByDefault = !f.given("pins") && !pins.empty();
  coloring.describe(f);
  if (pins.size() > shader::maxPinFrames)
    f.error("pins", fmt::format("at most {} groups of pins", shader::maxPinFrames));
  for (const PinGroup& group : pins) {
    if (!group.clamp || mesh) continue;
    if (!fabric) f.error("pins", "\"clamp\" needs the bending stiffness of a fabric; give \"fabric\"");
    bool border = false;
    for (int side = 0; side < 4; ++side) border = border || pinsBorder(group, side);
    if (!border) f.error("pins", "\"clamp\" holds borders: pin the first or last of the rows or columns");
  }
}

void ClothParameters::ports(Ports& ports) const {
  ports.want<Walls>(walls, {"walls"});
  if (air) ports.want<FluidWind>(air->fluid, {"air", "fluid"});
  for (std::size_t i = 0; i < pins.size(); ++i)
    ports.want<SkinnedSurface>(pins[i].to, {"pins", std::to_string(i), "to"});
  ports.wantAll<HeightField>();
  ports.provide<ContactCloth>(contact.has_value(), " without \"contact\", which lets particles through");
  ports.provide<Touchable>(contact.has_value());
  ports.provide<ColorScale>(coloring.used(), " without \"colorBy\": \"strain\" or \"speed\"");
  if (!contact) return;
  ports.wantAll<ContactSolid>();
  ports.join<LockStep>(true);
}

bool ClothParameters::pinsBorder(const PinGroup& group, int border) const {
  const std::vector<int>& lines = border < 2 ? group.columns : group.rows;
  const int last = (border < 2 ? size.x : size.y) - 1;
  return std::any_of(lines.begin(), lines.end(), [&](int line) {
    return (line < 0 ? line + last + 1 : line) == (border % 2 == 0 ? 0 : last);
  });
}

int ClothParameters::clampOf(int border) const {
  for (std::size_t i = 0; i < pins.size(); ++i)
    if (pins[i].clamp && pinsBorder(pins[i], border)) return static_cast<int>(i);
  return -1;
}

float ClothParameters::particleMass(glm::ivec2 at) const {
  if (!fabric) return mass;
  const auto share = [](int i, int count) { return i == 0 || i == count - 1 ? 0.5F : 1.0F; };
  return fabric->constants().density * spacing * spacing * share(at.x, size.x) * share(at.y, size.y);
}

float ClothParameters::contactThickness(float between) const {
  if (contact && contact->thickness) return static_cast<float>(*contact->thickness);
  const float own = fabric ? fabric->constants().thickness : 0.0F;
  return std::clamp(own, 0.125F * between, 0.35F * between);
}

ClothParameters ClothParameters::withContactSubsteps(int contactSubsteps) const {
  ClothParameters all = *this;
  if (contact && contactSubsteps > 0) all.substeps = contactSubsteps;
  return all;
}

int ClothParameters::fewestSubsteps(double frameSeconds, int otherwise) const {
  return contact ? std::max(otherwise, static_cast<int>(substepsFor(frameSeconds, 1.0 / 960))) : otherwise;
}

double ClothParameters::fastestAir() const {
  if (!air) return 0;
  // Between two keys the velocity is linear, so its maximum is at a key. Each of the three components of a
  // gust is at most `gusts` times the speed, hence the factor sqrt(3).
  double fastest = 0;
  for (const auto& key : air->velocity.keys()) {
    const glm::dvec3 v(key.value);
    fastest = std::max(fastest, std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z));
  }
  return fastest * (1.0 + std::sqrt(3.0) * air->gusts) + (air->fluid.empty() ? 0.0 : air->fluidSpeed);
}

double ClothParameters::greatestLoad(double each) const {
  const auto greatest = [](const scene::Animated<glm::vec3>& vector) {
    double maximum = 0;
    for (const auto& key : vector.keys()) {
      const glm::dvec3 v(key.value);
      maximum = std::max(maximum, std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z));
    }
    return maximum;
  };
  return greatest(gravity) + greatest(wind) / each;
}

// The search is breadth-first, starting from all pinned particles at the same time.
int ClothParameters::maxOnOnePin() const {
  if (mesh) return 0;
  constexpr int nobody = -1;
  std::vector<int> pinOf(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), nobody);
  std::vector<int> reached;
  for (const PinGroup& group : pins)
    for (const int i : pinnedBy(group)) {
      if (pinOf[static_cast<std::size_t>(i)] != nobody) continue;
      pinOf[static_cast<std::size_t>(i)] = static_cast<int>(reached.size());
      reached.push_back(i);
    }
  std::vector<int> carried(reached.size(), 0);
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const int i = reached[next];
    const int pin = pinOf[static_cast<std::size_t>(i)];
    ++carried[static_cast<std::size_t>(pin)];
    const auto reach = [&](bool inside, int other) {
      if (!inside || pinOf[static_cast<std::size_t>(other)] != nobody) return;
      pinOf[static_cast<std::size_t>(other)] = pin;
      reached.push_back(other);
    };
    const int x = i % size.x;
    reach(x > 0, i - 1);
    reach(x + 1 < size.x, i + 1);
    reach(i >= size.x, i - size.x);
    reach(i + size.x < static_cast<int>(pinOf.size()), i + size.x);
  }
  return carried.empty() ? 0 : *std::ranges::max_element(carried);
}

double ClothParameters::hangingSquared() const {
  return 4.0 * std::max(size.x, size.y) * greatestLoad(particleMass(size / 2)) / spacing;
}

// The frequency is w^2 = 4 T / (m L) with the tension T = N m a, for N particles of mass m, the
// acceleration a and the spacing L. Although the tension decreases along the line, cotton sheets that hang
// by two corners become unstable at (w dt)^2 = 2.7 instead of 4; the factor 1.5 accounts for that.
double ClothParameters::pinnedSquared() const {
  return 1.5 * 4.0 * maxOnOnePin() * greatestLoad(particleMass(size / 2)) / spacing;
}

double ClothParameters::stableSeconds(double lines) const {
  // Semi-implicit Euler of x'' = -w^2 x - c x' stays bounded while (w dt)^2 + 2 c dt < 4. Near the rest
  // shape, the fastest mode of the lattice has w^2 <= 4 (k + ks + kb) / m, with the stiffnesses of the
  // structural, shear and bending springs and the particle mass m. Drag alone decelerates at the rate c =
  // rho (Cd + Cl) A |v| / m, the derivative of the quadratic force. Constraints alone do not limit the
  // substep. But the weight of N particles that hang from a line straightens it with the tension T = N m a,
  // and a straight line of masses swings sideways with w^2 <= 4 T / (m L) = 4 N a / L, where a is the
  // acceleration and L the spacing. Air pulls, too: a sheet that streams from a pole feels about a tenth of
  // its face-on drag.
  const double each = particleMass({1, 1});
  const double area = static_cast<double>(spacing) * spacing;
  const double fastest = fastestAir();
  const double streaming = air ? 0.1 * 0.5 * air->density * static_cast<double>(air->drag + air->lift) *
                                     fastest * fastest * area / each * lines
                               : 0.0;
  // If the constraints keep energy, the softening times w^2 dt^2 must be below 1, and the tension during a
  // swing exceeds the tension at rest. This is evaluated only for constraints, because maxOnOnePin()
  // visits every particle.
  const auto hanging = [&] {
    return (keepsEnergy() ? hangingSquared() * 6 * minSoftening
                          : std::max(hangingSquared(), pinnedSquared())) +
           4.0 * std::max(size.x, size.y) * streaming / spacing;
  };
  // The bending of a fabric with the stiffness D has w^2 <= 64 D / (L^2 m): 16 along each axis and 32 for
  // twisting.
  const double bending = fabric ? 64.0 * fabric->constants().bending / (area * each) : 0.0;
  const double w2 = constrained() ? hanging() + bending
                                  : 4.0 * static_cast<double>(stiffness) * (1.0 + shear + bend) / each;
  const double c =
      air ? air->density * static_cast<double>(air->drag + air->lift) * area * fastest / each : 0.0;
  const double rate = c + std::sqrt(c * c + 4.0 * w2);
  return rate > 0 ? 4.0 / rate : std::numeric_limits<double>::infinity();
}

std::string ClothParameters::steadierWay(double frameSeconds) const {
  ClothParameters other = *this;
  std::string milder = fabric ? "take a wider spacing, or a material that is heavier or bends more easily"
                              : "lower the stiffness or raise the mass";
  if (substeps && substepsFor(frameSeconds, safety * stableSeconds()) <= maxSubsteps)
    return "set \"substeps\": \"auto\", " + milder;
  if (fabric) return milder;
  other.solver = ClothSolver::constraints;
  if (!constrained() && substepsFor(frameSeconds, safety * other.stableSeconds()) <= maxSubsteps)
    return "set \"solver\": \"constraints\" (XPBD), which is stable at any stiffness, lower the stiffness "
           "or "
           "raise the mass";
  return "slow the air, lower its density, drag or lift, or raise the mass";
}

std::string ClothParameters::instability(double frameSeconds) const {
  if (mesh) return "";  // GarmentPlan checks the cloth of a mesh, because its limit depends on its faces
  const double stable = stableSeconds();
  if (!substeps || frameSeconds / *substeps <= stable) return "";
  return fmt::format(
      "{} {} fewer than the {} that its {} need to be stable (substep {:.3g} s, limit {:.3g} s); {}",
      *substeps, *substeps == 1 ? "substep is" : "substeps are", substepsFor(frameSeconds, stable),
      std::string(!constrained() ? "springs"
                  : fabric       ? "bending and hanging rows"
                                 : "hanging rows") +
          (air ? " and the fastest air" : ""),
      frameSeconds / *substeps, stable, steadierWay(frameSeconds));
}

int ClothParameters::substepsPerFrame(double frameSeconds) const {
  if (substeps) return *substeps;
  // Gusts concentrate the pull of a streaming sheet at one corner. The line at that corner carries its own
  // pull and a fraction of the pull of all other lines. The fraction was measured with the scene flag.json;
  // with half of it, the cloth of that scene stays stretched by a tenth. The number of substeps therefore
  // grows as 1 / L^1.5, where L is the spacing.
  constexpr double drawnPart = 1.0 / 72;
  const double drawn = constrained() ? 1.0 + drawnPart * std::min(size.x, size.y) : 1.0;
  const std::int64_t needed = substepsFor(frameSeconds, safety * stableSeconds(drawn));
  if (needed > maxSubsteps)
    fail(ExitCode::usage,
         "cloth: \"substeps\": \"auto\" would take {} a frame to be stable, more than {}; {}", needed,
         maxSubsteps, steadierWay(frameSeconds));
  const int min = fewestSubsteps(
      frameSeconds, keepsEnergy() ? static_cast<int>(substepsFor(frameSeconds * (1 - 1e-9), keepingSubstep))
                    : constrained() ? 8
                                    : 1);
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
