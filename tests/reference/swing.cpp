#include "reference/swing.hpp"

#include "reference/cloth_twin.hpp"
#include "reference/garment_twin.hpp"
#include "sim/cloth/quantities.hpp"
#include "sim/garment/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace simreel::swing {

namespace {

constexpr double frameSeconds = 1.0 / 60;
constexpr double gravity = 9.8;

sim::ClothParameters quiet(double degrees) {
  sim::ClothParameters p;
  p.wind = glm::vec3(0);
  p.damping = 0;
  p.rotation = glm::vec3(90.0 - degrees, 0, 0);
  p.pins.clear();
  return p;
}

Case sheet(double degrees, double spacing) {
  Case made;
  made.degrees = degrees;
  sim::ClothParameters& p = made.parameters;
  p = quiet(degrees);
  const int rows = static_cast<int>(std::lround(1 / spacing)) + 1;
  p.size = {(rows + 1) / 2, rows};
  p.spacing = static_cast<float>(spacing);
  p.pins.emplace_back().rows = {0};
  made.length = spacing * (rows - 1);
  return made;
}

/// Returns the quantity "energy" from a list of quantities.
double energyOf(const std::vector<double>& measured) {
  return measured[5];
}

}  // namespace

Case springs(double degrees, double spacing) {
  Case made = sheet(degrees, spacing);
  made.name = "springs";
  made.parameters.mass = static_cast<float>(spacing * spacing);  // The mass per area is 1 kg/m^2.
  made.parameters.substeps = spacing < 0.03 ? 64 : 32;           // These numbers of substeps limit w dt to
                                                                 // 0.7, where w is the highest angular
                                                                 // frequency of the lattice.
  return made;
}

Case fabric(double degrees, double spacing) {
  Case made = sheet(degrees, spacing);
  made.name = "fabric";
  made.parameters.fabric.emplace();
  made.parameters.substeps.reset();
  return made;
}

Case strip(double degrees, double spacing) {
  Case made;
  made.name = "strip of triangles";
  made.degrees = degrees;
  sim::ClothParameters& p = made.parameters;
  p = quiet(degrees);
  p.fabric.emplace();
  p.mesh.emplace();
  p.substeps.reset();
  const int rows = static_cast<int>(std::lround(1 / spacing)) + 1;
  p.mesh->size = glm::vec3(0.5F, 0, 1);
  p.mesh->resolution = {(rows + 1) / 2, rows};
  sim::PinGroup& top = p.pins.emplace_back();
  // x and y are the position of the sheet's upper border after the rotation by `degrees`.
  const double angle = degrees * 3.14159265358979 / 180;
  const auto y = static_cast<float>(0.5 * std::cos(angle)), z = static_cast<float>(-0.5 * std::sin(angle));
  top.box = sim::PinBox{glm::vec3(-1, y - 1e-3F, z - 1e-3F), glm::vec3(1, y + 1e-3F, z + 1e-3F)};
  made.length = 1;
  return made;
}

namespace {

/// The CPU twin of a case, with its energy.
template <class Twin, class Measure>
class Swinging {
 public:
  Swinging(Twin twin, Measure measure) : twin_(std::move(twin)), measure_(std::move(measure)) {}
  [[nodiscard]] double energy() {
    return energyOf(measure_(twin_.plan(), twin_.positions, twin_.velocities, frame_ * frameSeconds));
  }
  double energyAfter() {
    twin_.step(frame_++ * frameSeconds);
    return energy();
  }
  /// Returns the energy of the cloth when it hangs straight down at its rest length.
  double energyHanging(double degrees) {
    const auto start = twin_.positions;
    double top = -1e300;
    for (const glm::vec4& p : start) top = std::max(top, static_cast<double>(p.y));
    const double part = std::cos(degrees * 3.14159265358979 / 180);
    for (glm::vec4& p : twin_.positions)
      p = glm::vec4(p.x, top - (top - static_cast<double>(p.y)) / part, 0, p.w);
    const double hanging = energy();
    twin_.positions = start;
    return hanging;
  }

 private:
  Twin twin_;
  Measure measure_;
  int frame_ = 0;
};

/// Calls `use` with the CPU twin (Swinging) of the case.
template <class Use>
auto withTwin(const Case& given, const Use& use) {
  const sim::ClothParameters& p = given.parameters;
  if (p.mesh)
    return use(
        Swinging(GarmentTwin(sim::GarmentPlan("strip", p, 1, frameSeconds, {})), sim::measureGarment));
  return use(
      Swinging(ClothTwin(sim::ClothPlan(p, 1, frameSeconds, {})),
               [](const sim::ClothPlan& plan, const auto& positions, const auto& velocities, double time) {
                 return sim::measureCloth(plan.parameters(), positions, velocities, time, plan.softness());
               }));
}

}  // namespace

Course courseOf(const Case& given, double seconds, const std::function<double()>& energyAfter) {
  const auto [first, hanging] = withTwin(
      given, [&](auto twin) { return std::pair(twin.energy(), twin.energyHanging(given.degrees)); });
  // A hanging chain of length L swings with the angular frequency (j01 / 2) sqrt(g / L), where j01 = 2.405
  // is the first zero of the Bessel function J0.
  const double period = 2 * 3.14159265358979 / (1.2024 * std::sqrt(gravity / given.length));
  const int frames = static_cast<int>(std::lround(seconds / frameSeconds));
  const int window = static_cast<int>(std::lround(period / frameSeconds));
  Course course;
  double sum = 0;
  double lowest = 1e300;
  for (int frame = 1; frame <= frames; ++frame) {
    sum += (energyAfter() - hanging) / (first - hanging);
    if (frame % window != 0) continue;
    const double mean = sum / window;
    sum = 0;
    if (frame == window) continue;
    course.means.push_back(mean);
    course.rise = std::max(course.rise, mean - lowest);
    lowest = std::min(lowest, mean);
  }
  return course;
}

Course courseOfTwin(const Case& given, double seconds) {
  return withTwin(given,
                  [&](auto twin) { return courseOf(given, seconds, [&] { return twin.energyAfter(); }); });
}

}  // namespace simreel::swing
